#include "base/units.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "base/constants.hpp"

namespace shmoo::base {
namespace {

using namespace dimensions;

struct Example {
  const char* text;
  double value;  // SI
  Dimension dimension;
};

class Units : public testing::TestWithParam<Example> {};

TEST_P(Units, AreReadAsSI) {
  const auto [text, value, dimension] = GetParam();
  const Measured measured = parse_quantity(text);
  EXPECT_EQ(measured.dimension, dimension) << si_unit(measured.dimension);
  EXPECT_NEAR(measured.value, value, 4e-16 * std::abs(value));
}

INSTANTIATE_TEST_SUITE_P(
    Examples, Units,
    testing::Values(
        Example{"347 um^2/s", 347e-12, diffusivity}, Example{"1 mol/m^3", avogadro, concentration},
        Example{"10 nM", 10 * avogadro * 1e-6, concentration}, Example{"1 M", 1000 * avogadro, concentration},
        Example{"2 mM", 2 * avogadro, concentration}, Example{"3 uM", 3e-3 * avogadro, concentration},
        Example{"3 \u00b5M", 3e-3 * avogadro, concentration}, Example{"3 \u03bcM", 3e-3 * avogadro, concentration},
        Example{"5 pM", 5e-9 * avogadro, concentration},
        Example{"6.022e6 1/(M s)", 6.022e6 / (1000 * avogadro), rate_constant(2)},
        Example{"1e-3 Pa s", 1e-3, viscosity}, Example{"100 molecules/um^3", 1e20, concentration},
        Example{"+1e3 1/s", 1000, frequency}, Example{"-4 m/s", -4, speed}, Example{"20 degC", 293.15, temperature},
        Example{"180 degrees/s", 3.14159265358979312, frequency}, Example{"1 kat", avogadro, amount / dimensions::time},
        Example{"1 uL", 1e-9, volume}, Example{"2 min", 120, dimensions::time}, Example{"1 h", 3600, dimensions::time},
        Example{"4.14 pN nm", 4.14e-21, energy}, Example{"5 %", 0.05, none}, Example{"1 cP", 1e-3, viscosity},
        Example{"1 Pa s", 1, viscosity}));

TEST(Units, MoleculesAreExact) {
  for (const double count : {1.0, 3.0, 2000.0, 9007199254740991.0})
    EXPECT_EQ(parse_quantity(std::to_string(static_cast<long long>(count)) + " molecules").value, count);
  EXPECT_EQ(parse_quantity("1 mol").value, 6.02214076e23);
  EXPECT_EQ(parse_quantity("1 mole").value, 6.02214076e23);
}

TEST(Units, RefusesWhatIsNoQuantity) {
  for (const char* text : {"",
                           " ",
                           "4",
                           "4 ",
                           "um",
                           "4 umm",
                           "nan s",
                           "inf s",
                           "-inf s",
                           "1e999 s",
                           "1e-999 s",
                           "1e300 km^3",
                           "1e-320 fs^2",
                           "4 s since 2000-01-01",
                           "4 lg(re 1 mW)",
                           "4 2 s",
                           "+-4 s",
                           "4 @ s",
                           "4 (",
                           "4 ((m)",
                           "four s",
                           "0x10 s",
                           "1,5 m",
                           "4 m/",
                           "4 m^",
                           "1 m\n",
                           "3 \xff"})
    EXPECT_THROW(parse_quantity(text), QuantityError) << text;
  EXPECT_THROW(parse_quantity("1 " + std::string(10000, '(')), QuantityError);
}

TEST(Units, SpeaksOfDimensions) {
  EXPECT_EQ(si_unit(rate_constant(2)), "m^3/(molecule s)");
  EXPECT_EQ(si_unit(none), "1");
  EXPECT_EQ(si_unit(frequency), "1/s");
  EXPECT_EQ(expectation(length), "a length [m], such as \"1 um\"");
  EXPECT_EQ(dimension_name(mass / temperature), "a quantity in kg/K");
  EXPECT_EQ(dimension_name(length), "a length [m]");
}

TEST(Units, ExamplesOfMessagesAreWhatTheySay) {
  for (const Dimension& dimension : {length,
                                     area,
                                     volume,
                                     dimensions::time,
                                     mass,
                                     temperature,
                                     amount,
                                     speed,
                                     acceleration,
                                     frequency,
                                     density,
                                     energy,
                                     pressure,
                                     viscosity,
                                     diffusivity,
                                     concentration,
                                     flux,
                                     rate_constant(0),
                                     rate_constant(2),
                                     rate_constant(3)}) {
    const std::string text = expectation(dimension);
    const auto first = text.find('"');
    ASSERT_NE(first, std::string::npos) << text;
    const std::string example = text.substr(first + 1, text.size() - first - 2);
    EXPECT_EQ(parse_quantity(example).dimension, dimension) << example;
  }
}

TEST(Units, CanBeReadByManyThreads) {
  std::vector<double> values(8);
  std::vector<std::thread> threads;
  for (double& value : values)
    threads.emplace_back([&value] {
      for (int i = 0; i < 200; ++i) value += parse_quantity("1 nmol/(um^2 ms)").value / 200;
    });
  for (auto& thread : threads) thread.join();
  for (const double value : values) EXPECT_EQ(value, values.front());
}

}  // namespace
}  // namespace shmoo::base
