// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <fstream>
#include <limits>

#include <riprap/core/errors.hpp>
#include <riprap/output/record.hpp>

namespace riprap {

namespace internal {

inline constexpr std::size_t record_head = 8;  // kind, length
inline constexpr std::size_t array_head = 16;  // name, type, number of values
inline constexpr std::size_t longest_name = 11;

template <class T>
[[nodiscard]] T number_at(std::string_view bytes, std::size_t place) {
  T value{};
  std::memcpy(&value, bytes.data() + place, sizeof(T));
  return value;
}

template <class T>
[[nodiscard]] std::vector<double> numbers_at(std::string_view bytes, std::size_t place,
                                             std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t k = 0; k < count; ++k)
    values[k] = static_cast<double>(number_at<T>(bytes, place + k * sizeof(T)));
  return values;
}

/// The arrays of a record; false if they do not end where the record does.
[[nodiscard]] RIPRAP_INLINE bool read_arrays(std::string_view bytes, ReadRecord& record) {
  std::size_t place = 0;
  while (bytes.size() - place >= array_head) {
    std::string name(bytes.substr(place, longest_name));
    name.resize(std::strlen(name.c_str()));
    const char type = bytes[place + longest_name];
    const auto count = number_at<std::uint32_t>(bytes, place + longest_name + 1);
    place += array_head;
    const std::size_t width = type == 'd' || type == 'Q' ? 8 : 4;
    if ((bytes.size() - place) / width < count) return false;
    std::vector<double>& values = record.arrays[name];
    if (type == 'f')
      values = numbers_at<float>(bytes, place, count);
    else if (type == 'd')
      values = numbers_at<double>(bytes, place, count);
    else if (type == 'I')
      values = numbers_at<std::uint32_t>(bytes, place, count);
    else if (type == 'Q')
      values = numbers_at<std::uint64_t>(bytes, place, count);
    else
      return false;
    place += count * width;
  }
  return place == bytes.size();
}

}  // namespace internal

RIPRAP_INLINE Record::Record(std::string_view kind) : bytes_(kind) {
  require(kind.size() == 4, "Record: characters of the kind", static_cast<double>(kind.size()),
          "must be 4");
  bytes_.resize(internal::record_head, '\0');
}

RIPRAP_INLINE void Record::begin_array(std::string_view name, char type, std::size_t count) {
  require(name.size() <= internal::longest_name, "Record: characters of a name",
          static_cast<double>(name.size()), "must be at most 11");
  bytes_.append(name);
  bytes_.append(internal::longest_name - name.size(), '\0');
  bytes_ += type;
  const auto values = static_cast<std::uint32_t>(count);
  append(&values, sizeof values);
}

RIPRAP_INLINE void Record::append(const void* data, std::size_t size) {
  bytes_.append(static_cast<const char*>(data), size);
  const std::size_t length = bytes_.size() - internal::record_head;
  require(length <= std::numeric_limits<std::uint32_t>::max(), "Record: bytes",
          static_cast<double>(length), "must be below 4 GiB");
  const auto number = static_cast<std::uint32_t>(length);
  std::memcpy(bytes_.data() + 4, &number, sizeof number);
}

RIPRAP_INLINE const std::vector<double>& ReadRecord::operator[](std::string_view name) const {
  const auto found = arrays.find(name);
  if (found == arrays.end())
    throw InvalidInput("record " + kind + ": has no array " + std::string(name));
  return found->second;
}

RIPRAP_INLINE double ReadRecord::number(std::string_view name) const {
  const std::vector<double>& values = (*this)[name];
  if (values.empty())
    throw InvalidInput("record " + kind + ": array " + std::string(name) + " is empty");
  return values.front();
}

RIPRAP_INLINE void read_records(const std::string& path, std::string_view signature,
                                const std::function<void(const ReadRecord&)>& visit) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InvalidInput(path + ": must be a file that can be read");
  std::string bytes(signature.size(), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file || bytes != signature)
    throw InvalidInput(path + ": must start with " + std::string(signature));
  file.seekg(0, std::ios::end);
  auto left = static_cast<std::uint64_t>(file.tellg()) - signature.size();
  file.seekg(static_cast<std::streamoff>(signature.size()));
  std::array<char, internal::record_head> head{};
  while (left >= head.size() && file.read(head.data(), head.size())) {
    left -= head.size();
    const auto length = internal::number_at<std::uint32_t>({head.data(), head.size()}, 4);
    if (length > left) return;  // cut short
    bytes.resize(length);
    file.read(bytes.data(), length);
    if (!file) return;
    left -= length;
    ReadRecord record{.kind = std::string(head.data(), 4)};
    if (!internal::read_arrays(bytes, record))
      throw InvalidInput(path + ": record " + record.kind + ": an array does not end with it");
    visit(record);
  }
}

}  // namespace riprap
