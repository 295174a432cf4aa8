#include <gtest/gtest.h>

#include <lobelia/result.h>

namespace lobelia {

TEST(Result, HoldsAValueOrAnError) {
    const Result<int> value = 3;
    ASSERT_TRUE(value);
    EXPECT_EQ(*value, 3);

    const Result<int> error = Error{VK_ERROR_DEVICE_LOST, "wait"};
    ASSERT_FALSE(error);
    EXPECT_EQ(error.error().code, VK_ERROR_DEVICE_LOST);
    EXPECT_STREQ(error.error().step, "wait");
}

} // namespace lobelia
