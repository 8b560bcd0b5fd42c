// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cstring>
#include <string>
#include <vector>

#include <riprap/checkpoint/sealed_image.hpp>
#include <support/message_of.hpp>

using namespace riprap;

namespace {

constexpr std::size_t size = 700;

[[nodiscard]] std::vector<std::byte> sealed() {
  std::vector<std::byte> image(size);
  for (std::size_t k = 512; k < size; ++k) image[k] = static_cast<std::byte>(7 * k);
  seal_image(image);
  return image;
}

[[nodiscard]] std::string message(const std::vector<std::byte>& image) {
  return test::message_of([&] { check_sealed_image(image, "FILE"); });
}

}  // namespace

TEST_CASE("The head is text, and a whole image is accepted") {
  const std::vector<std::byte> image = sealed();
  CHECK(message(image).empty());
  std::string head(512, '\0');
  std::memcpy(head.data(), image.data(), head.size());
  CHECK(head.starts_with("riprap checkpoint\nschema 4\nbytes 700\ndigest "));
  CHECK(head.ends_with(" \n"));
}

TEST_CASE("An image that is truncated at any byte is refused") {
  for (std::size_t k = 0; k < size; ++k) {
    std::vector<std::byte> image = sealed();
    image.resize(k);
    CAPTURE(k);
    CHECK_THROWS_AS(check_sealed_image(image, "FILE"), DamagedCheckpoint);
    CHECK(test::contains(message(image), k == 0 ? "is empty" : "is truncated: "));
  }
}

TEST_CASE("An image with any bit changed is refused") {
  for (std::size_t k = 0; k < size; ++k) {
    std::vector<std::byte> image = sealed();
    image[k] ^= static_cast<std::byte>(1 << (k % 8));
    CAPTURE(k);
    CHECK_FALSE(message(image).empty());
  }
}

TEST_CASE("What is no checkpoint, and one of a newer riprap, is refused by name") {
  std::vector<std::byte> image(size, std::byte{'x'});
  CHECK(message(image) == "FILE is no checkpoint of riprap");
  image = sealed();
  image.push_back({});
  CHECK(message(image) == "FILE is damaged: 701 of 700 bytes");

  image = sealed();
  image[std::strlen("riprap checkpoint\nschema ")] = std::byte{'5'};
  CHECK(message(image) == "FILE is a checkpoint of another version of riprap: schema 5, and this "
                          "one reads 4");
}

TEST_CASE("A newer schema is refused by name whatever its head holds besides") {
  const std::string refusal = "FILE is a checkpoint of another version of riprap: schema 12, and "
                              "this one reads 4";
  for (const char* const rest : {"", "layout columns\nsha256 0123\n", "bytes 1\ndigest 0\n"}) {
    const std::string text = std::string("riprap checkpoint\nschema 12\n") + rest;
    std::vector<std::byte> image(text.size());
    std::memcpy(image.data(), text.data(), text.size());
    for (const std::size_t length : {text.size(), size}) {  // a head of another length, too
      image.resize(length);
      CHECK(message(image) == refusal);
      try {
        check_sealed_image(image, "FILE");
      } catch (const DamagedCheckpoint&) {
        FAIL("a folder would go on with an older file");
      } catch (const InvalidInput&) {
      }
    }
  }
}
