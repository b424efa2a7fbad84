#include <gtest/gtest.h>
#include <heed/model/variable.h>

namespace heed::model {
namespace {

TEST(Domain, EveryCodeReadsBack) {
  for (const Domain& domain :
       {Domain::boolean(), Domain::integer(-3, 12), Domain::enumeration({"unknown", "red", "true", "7"})}) {
    for (std::int32_t code = domain.low; code <= domain.high; ++code)
      EXPECT_EQ(domain.read(domain.print(code)), code) << domain.print(code);
    EXPECT_EQ(domain.size(), domain.high - domain.low + 1);
  }
}

TEST(Domain, ReadsOnlyItsOwnValuesAsTheyArePrinted) {
  EXPECT_FALSE(Domain::boolean().read("1"));
  EXPECT_FALSE(Domain::boolean().read("True"));
  const Domain integer = Domain::integer(-3, 12);
  for (const char* text : {"13", "-4", "", "x", "3 ", "+3", "03", "-0", "99999999999999"})
    EXPECT_FALSE(integer.read(text)) << text;
  EXPECT_FALSE(Domain::enumeration({"red"}).read("0"));
  EXPECT_FALSE(Domain::enumeration({"red"}).read("Red"));
}

TEST(Domain, SizeDoesNotOverflow) {
  EXPECT_EQ(Domain::integer(INT32_MIN, INT32_MAX).size(), std::int64_t{1} << 32);
  EXPECT_EQ(Domain::integer(INT32_MIN, INT32_MAX).print(INT32_MIN), "-2147483648");
}

TEST(Domain, EqualityIsByKindAndValues) {
  EXPECT_EQ(Domain::enumeration({"a", "b"}), Domain::enumeration({"a", "b"}));
  EXPECT_FALSE(Domain::enumeration({"a", "b"}) == Domain::enumeration({"b", "a"}));
  EXPECT_FALSE(Domain::boolean() == Domain::integer(0, 1));
}

}  // namespace
}  // namespace heed::model
