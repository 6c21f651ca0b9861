#include <gtest/gtest.h>

#include <federation/submap_text.hpp>

namespace tcert::federation {
namespace {

constexpr std::string_view kText =
    "tcert-submap,1\n"
    "synthetic,1\n"
    "agent,0.45,0.35,0,0\n"
    "source,a/t1,witness,0.02,-\n"
    "node,-1.5,0.25,0.1,S,0.3\n"
    "node,2,0,-3,G,-\n"
    "edge,0,front,1,back,0.125,0.003\n";

TEST(SubmapText, ReadsWhatItWrites) {
  const ReadSubmap read = read_submap(kText);
  ASSERT_TRUE(read.submap) << to_string(read.problem);
  EXPECT_EQ(to_text(*read.submap), kText);
  const Source& source = read.submap->sources.front();
  EXPECT_EQ(source.frame_error_m, 0.02);
  EXPECT_TRUE(std::isinf(source.frame_error_rad));
  EXPECT_TRUE(source.nodes[0].in_start && source.nodes[1].in_goal);
}

TEST(SubmapText, PutsInOrderWhatItReads) {
  const ReadSubmap read = read_submap(
      "tcert-submap,1\r\n# of two robots\r\n\r\nagent,0.45,0.35,0,0\r\n"
      "source,b,width,-,-\r\nsource,a/"
      "t1,witness,0.02,-\r\nnode,2,0,-3,G,-\r\nnode,-1.5,0.25,0.1,S,-\r\n"
      "node,2,0,-3,-,0.25\r\nedge,0,back,1,front,0.1,-\r\nedge,1,front,2,back,0.125,0.003\r\n");
  ASSERT_TRUE(read.submap) << to_string(read.problem);
  EXPECT_EQ(
      to_text(*read.submap),
      "tcert-submap,1\nagent,0.45,0.35,0,0\nsource,a/t1,witness,0.02,-\n"
      "node,-1.5,0.25,0.1,S,-\nnode,2,0,-3,G,0.25\nedge,0,front,1,back,0.125,0.003\nsource,b,width,"
      "-,-\n");
}

void expect_problem(const std::string& text, const std::string& problem) {
  const ReadSubmap read = read_submap(text);
  EXPECT_FALSE(read.submap) << text;
  EXPECT_EQ(to_string(read.problem), problem);
}

TEST(SubmapText, SaysWhatIsWrongAndWhere) {
  const std::string head = "tcert-submap,1\nagent,0.45,0.35,0,0\n";
  expect_problem("", "found 'nothing', expected tcert-submap,1");
  expect_problem("tcert-submap,2\n",
                 "line 1, cell 2: found '2', expected version 1, the only one that this reader "
                 "knows");
  expect_problem("tcert-submap,1\nsource,a,width,-,-\n",
                 "line 2: found 'source,a,width,-,-', expected agent, before any source");
  expect_problem("tcert-submap,1\nagent,0.45,0.35,nan,0\n",
                 "line 2, cell 4: found 'nan', expected a number from 0 to 10000");
  expect_problem("tcert-submap,1\n", "line 1: found 'the end', expected a line 'agent'");
  expect_problem(head + "node,1,2,3,S,-\n",
                 "line 3: found 'node,1,2,3,S,-', expected a source before it");
  expect_problem(head + "source,a b,width,-,-\n",
                 "line 3, cell 2: found 'a b', expected 1 to 100 letters, digits, '.', '_', '-' or "
                 "'/'");
  expect_problem(head + "source,a,felt,-,-\n",
                 "line 3, cell 3: found 'felt', expected witness, swept, radial or width");
  expect_problem(head + "source,a,width,-0.1,-\n",
                 "line 3, cell 4: found '-0.1', expected a number from 0 to 1e+09");
  expect_problem(head + "source,a,width,0,0\nnode,1,2,3,X,-\n",
                 "line 4, cell 5: found 'X', expected S, G, SG or -");
  expect_problem(head + "source,a,width,0,0\nnode,1,2,3,-,-\nedge,0,front,1,back,0.1,-\n",
                 "line 5, cell 4: found '1', expected a node of the source above it, of which "
                 "there are 1");
  expect_problem(head + "source,a,width,0,0\nnode,1,2,3,-,-\nedge,0,front,0,left,0.1,-\n",
                 "line 5, cell 5: found 'left', expected front or back");
  expect_problem("tcert-submap,1\nsynthetic,x\n",
                 "line 2, cell 2: found 'x', expected a seed, - or several");
  expect_problem(head + "what\n", "line 3, cell 1: found 'what', expected source, node or edge");
}

TEST(SubmapText, IsBounded) {
  const ReadSubmap read = read_submap(std::string(kMostBytes + 1, '#'));
  EXPECT_FALSE(read.submap);
}

}  // namespace
}  // namespace tcert::federation
