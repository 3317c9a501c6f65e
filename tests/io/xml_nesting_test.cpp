#include "io/xml_nesting.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

TEST(XmlNesting, CountsElementsInsideOneAnother) {
  EXPECT_EQ(nesting_depth(""), 0);
  EXPECT_EQ(nesting_depth("text > text"), 0);
  EXPECT_EQ(nesting_depth("<?xml version='1.0'?><a><b/><c></c></a>"), 2);
  EXPECT_EQ(nesting_depth("<a><a><a>"), 3);
  EXPECT_EQ(nesting_depth("<a><"), 2);
  EXPECT_EQ(nesting_depth("<a/><a/><a/>"), 0);
}

TEST(XmlNesting, DoesNotCountTagsInCommentsAndQuotes) {
  EXPECT_EQ(nesting_depth("<a><!-- <b><c> --></a>"), 1);
  EXPECT_EQ(nesting_depth(R"(<a text="/>"><b text='>'></b></a>)"), 2);
  EXPECT_EQ(nesting_depth("<a><!-- <b>"), 1);
}

}  // namespace
}  // namespace symscene
