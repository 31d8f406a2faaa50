// The random cases of decorated_test.cpp meet all pairs of features: mistakes hide where two of them meet.
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "decorated.hpp"

namespace pardel::properties {
namespace {

using generators::Decoration;

struct Feature {
  std::string name;
  /// True if the case has the feature, and its domain has what the feature is about.
  std::function<bool(const DecoratedCase&)> is_in;
};

bool is_about_regions(Wish wish) { return wish == Wish::caps_of_regions || wish == Wish::lengths_in_regions; }

/// Every feature that is drawn: decorations, wishes and ways.
std::vector<Feature> all_features() {
  std::vector<Feature> features;
  for (std::size_t i = 0; i < generators::Decorations{}.on.size(); ++i) {
    const auto decoration = static_cast<Decoration>(i);
    features.push_back({name(decoration), [=](const DecoratedCase& c) {
                          const bool has_subject =
                              decoration == Decoration::region_attributes ? !c.plain.domain.regions.empty()
                              : decoration == Decoration::segment_markers ? !c.plain.domain.segments.empty()
                                                                          : true;
                          return has_subject && c.plain.domain.decorations.has(decoration);
                        }});
  }
  for (std::size_t i = 0; i < Wishes{}.on.size(); ++i) {
    const auto wish = static_cast<Wish>(i);
    features.push_back({name(wish), [=](const DecoratedCase& c) {
                          const bool has_subject = is_about_regions(wish)       ? !c.plain.domain.regions.empty()
                                                   : wish == Wish::kept_markers ? !c.plain.domain.segments.empty()
                                                                                : true;
                          return has_subject && c.wishes.has(wish);
                        }});
  }
  for (std::size_t i = 0; i < Ways{}.on.size(); ++i) {
    const auto way = static_cast<Way>(i);
    features.push_back({name(way), [=](const DecoratedCase& c) { return c.ways.has(way); }});
  }
  return features;
}

TEST(DecoratedCases, have_every_pair_of_features) {
  constexpr int cases = 2000;  // as many as a property has
  constexpr int least = 5;
  const std::vector<Feature> features = all_features();
  std::vector<std::vector<int>> together(features.size(), std::vector<int>(features.size(), 0));
  for (int seed = 0; seed < cases; ++seed) {
    generators::Random random(static_cast<std::uint64_t>(seed));
    const DecoratedCase c = any_decorated_case(random, seed % 100);
    std::vector<std::size_t> has;
    for (std::size_t i = 0; i < features.size(); ++i)
      if (features[i].is_in(c)) has.push_back(i);
    for (const std::size_t i : has)
      for (const std::size_t j : has) ++together[i][j];
  }
  for (std::size_t i = 0; i < features.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      EXPECT_GE(together[i][j], least) << features[i].name << " with " << features[j].name;
}

TEST(DecoratedCases, name_each_feature_once) {
  std::set<std::string> names;
  for (const Feature& feature : all_features()) names.insert(feature.name);
  EXPECT_EQ(names.size(), all_features().size());
}

}  // namespace
}  // namespace pardel::properties
