#include "io/review_choices.hpp"

#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

/// One model "a" with one axis and this order.
std::string with_order(const std::string& order) {
  return R"({"version": 1, "models": [{"name": "a", "symmetries": [{"kind": "axis", "order": )" +
         order + R"(, "point": [1, 2, 3], "direction": [0, 0, 2], "choice": "rejected"}]}]})";
}

std::string refusal_of(const std::string& text) {
  return refusal([&] { parse_review_choices(text, "c.json"); });
}

TEST(ReviewChoices, AreReadWithDirectionsOfUnitLength) {
  const ReviewChoicesByModel models = parse_review_choices(with_order("4"), "c.json");
  ASSERT_EQ(models.size(), 1U);
  const ReviewChoice& choice = models.at("a").at(0);
  EXPECT_EQ(choice.kind, "axis");
  EXPECT_EQ(choice.choice, "rejected");
  EXPECT_EQ(choice.point, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(choice.direction, Eigen::Vector3d(0.0, 0.0, 1.0));
  EXPECT_EQ(choice.order, 4);
}

TEST(ReviewChoices, AnyAngleIsAWordAndNoNumberMeansIt) {
  const auto order_of = [](const std::string& order) {
    return parse_review_choices(with_order(order), "c.json").at("a").at(0).order;
  };
  EXPECT_EQ(order_of("\"continuous\""), ReviewChoice::continuous);
  EXPECT_EQ(order_of("null"), std::nullopt);
  EXPECT_EQ(order_of("24"), 24);
  for (const char* other : {"0", "1", "25", "4294967296", "4294967298"})
    EXPECT_NE(refusal_of(with_order(other)).find("expected 2 to 24 or continuous"),
              std::string::npos)
        << other;
}

TEST(ReviewChoices, RefusalsNameTheFileAndThePlace) {
  const std::string found = refusal_of(with_order("\"two\""));
  EXPECT_TRUE(found.starts_with("c.json: ")) << found;
  EXPECT_NE(found.find("order"), std::string::npos) << found;
}

}  // namespace
}  // namespace symscene
