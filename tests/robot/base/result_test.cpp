// SPDX-License-Identifier: MIT
#include "robot/base/result.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace sensotwin::robot {
namespace {

enum class Mishap { kTimeout, kUnplugged };

Result<int, Mishap> half_of_even(int n) {
  if (n % 2 != 0) {
    return Unexpected{Mishap::kUnplugged};
  }
  return n / 2;
}

TEST(AResult, HoldsItsValue) {
  const auto result = half_of_even(8);
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result);
  EXPECT_EQ(*result, 4);
}

TEST(AResult, HoldsTheReasonWhyThereIsNone) {
  const auto result = half_of_even(7);
  EXPECT_FALSE(result.has_value());
  EXPECT_FALSE(result);
  EXPECT_EQ(result.error(), Mishap::kUnplugged);
}

TEST(AResult, TellsValueFromErrorWhenBothAreOfOneType) {
  const Result<std::string, std::string> value{std::string{"x"}};
  const Result<std::string, std::string> error{Unexpected{std::string{"x"}}};
  EXPECT_TRUE(value.has_value());
  EXPECT_FALSE(error.has_value());
}

TEST(AResult, CarriesWhatCanOnlyBeMoved) {
  Result<std::unique_ptr<int>, Mishap> result{std::make_unique<int>(5)};
  const std::unique_ptr<int> taken = std::move(*result);
  EXPECT_EQ(*taken, 5);
}

TEST(AResult, LetsItsValueBeChangedInPlace) {
  Result<std::string, Mishap> result{std::string{"tile"}};
  *result += "s";
  EXPECT_EQ(result->size(), 5u);
}

TEST(AResultDeathTest, StopsAProgramThatTakesAValueThatIsNotThere) {
  const auto result = half_of_even(7);
  EXPECT_DEATH(static_cast<void>(*result), "has_value");
}

}  // namespace
}  // namespace sensotwin::robot
