#include <riprap/riprap.hpp>

int main() {}
