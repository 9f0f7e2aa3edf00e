// The schema of study files.
#include "scene/forms.hpp"
#include "scene/tables.hpp"

namespace shmoo::scene {

using namespace forms;

namespace {

// Any value that a key of a model may take.
Key set_key() {
  const Form words = text("any text"), numbers = number(any), flag = boolean();
  return {"set",
          {named({words, numbers, flag, list({words, numbers, flag})}, "the path of a key of the model")},
          false,
          "{}",
          "values that replace the model's, as `--set` does: { \"domain.spacing\" = \"1 um\" }"};
}

std::vector<Form> number_or_path() {
  return {unit_later("a number, a quantity, or the path of a key of the model"), text("the path of a key of the model"),
          number(any)};
}

Table study_table() {
  return {"study",
          "the file",
          "A study runs one model by several methods at several levels (resolutions, steps, tolerances) and measures "
          "errors against CPU time.",
          {{"title", {text("any text")}, true, "", "what is studied, in one line"},
           {"name", {text("letters, digits, _ and -")}, true, "", "of the study's files"},
           {"model", {text("the path of a model file, from here")}, true, "", "what is run"},
           {"regime", {text("any text")}, false, "the title", "the kind of problem that the study stands for"},
           {"resolution",
            {text("the path of a key of the model, or the name of a derived number")},
            false,
            "\"domain.spacing\"",
            "the number against which orders are measured"},
           {"budget", {quantity(dimensions::time, positive)}, false, "\"10 min\"", "CPU time that one run may take"},
           {"wanted",
            {list({number(positive)})},
            false,
            "[]",
            "accuracies for which the study says what to choose and what it costs"},
           {"method", {list({subtable("study_method")}, 1)}, true, "", "ways to compute it"},
           {"level", {list({subtable("study_level")}, 1)}, true, "", "from coarse to fine"},
           {"quantity", {list({subtable("study_quantity")}, 1)}, true, "", "what is compared with what"}}};
}

Table method_table() {
  return {
      "study_method",
      "[[method]]",
      "A way to compute it: a line of the plot.",
      {{"name", {text("letters, digits, _ and -")}, true, "", "what it is called"},
       set_key(),
       {"realisations", {integer(1, 500000)}, false, "the model's", "of one ensemble"},
       {"levels", {list({text("the name of a level")}, 1)}, false, "all", "the levels at which it is run"},
       {"repeats", {integer(1, 1000)}, false, "1", "ensembles with seeds of their own, which give the error bars"},
       {"mean_of",
        {text("the name of a method")},
        false,
        "",
        "a method whose solution this one's mean should be: where the two differ by more than chance, that is bias"}}};
}

Table level_table() {
  return {"study_level",
          "[[level]]",
          "A resolution, for all methods.",
          {{"name", {text("any text")}, true, "", "what it is called"}, set_key()}};
}

Table quantity_table() {
  return {
      "study_quantity",
      "[[quantity]]",
      "What is measured. Without `time` and the windows `average`, `amplitude`, `period`, `harmonic` and "
      "`harmonic_period` it is taken at the last record.",
      {{"name", {text("letters, digits, _ and -")}, true, "", "what it is called"},
       {"field",
        {text("the name of a species or field")},
        false,
        "",
        "at every particle that holds it; of a species, its concentration"},
       {"observable", {text("the name of an observable")}, false, "", "a number or profile that the model records"},
       {"component", {choice({"x", "y", "z"})}, false, "\"x\"", "of a vector field"},
       {"time",
        {quantity(dimensions::time, not_negative), list({quantity(dimensions::time, not_negative)}, 1)},
        false,
        "the last record",
        "records to take"},
       {"average",
        {list({quantity(dimensions::time, not_negative)}, 2, 2)},
        false,
        "",
        "the mean of an observable over all records from the first time to the second"},
       {"amplitude",
        {list({quantity(dimensions::time, not_negative)}, 2, 2)},
        false,
        "",
        "half the difference between the largest and the least value of an observable in the records from the first "
        "time to the second"},
       {"period",
        {list({quantity(dimensions::time, not_negative)}, 2, 2)},
        false,
        "",
        "the first period of an observable in the records from the first time to the second: between crossings, in "
        "the same direction, of the middle between its extremes"},
       {"harmonic",
        {list({quantity(dimensions::time, not_negative)}, 2, 2)},
        false,
        "",
        "amplitude of the strongest sine in an observable from the first time to the second, by least squares: noise "
        "moves it little"},
       {"harmonic_period",
        {list({quantity(dimensions::time, not_negative)}, 2, 2)},
        false,
        "",
        "the period of that sine"},
       {"reference", {subtable("study_reference")}, true, "", "what it should be"},
       {"norm",
        {choice({"rms", "maximum", "root_sum_over_n"})},
        false,
        "\"rms\"",
        "of the errors e of N places and times: sqrt(sum e^2/N), the largest |e|, or sqrt(sum e^2)/N"},
       {"scale", number_or_path(), false, "1", "what errors are divided by"},
       {"relative", {boolean()}, false, "false", "errors are divided by the reference instead, place by place"},
       {"published",
        {named({list({number(not_negative)}, 1)}, "the name of a method")},
        false,
        "{}",
        "errors that others published, one per level; 0 where there is none"},
       {"published_norm",
        {choice({"rms", "maximum", "root_sum_over_n"})},
        false,
        "`norm`",
        "in which they are published"}},
      ShapeUse::optional};
}

Table reference_table() {
  return {"study_reference",
          "[quantity.reference]",
          "What the quantity should be: one of `formula`, `table`, `finest`, `method`, `value`; `method` and `finest` "
          "together are that method at the last level.",
          {{"formula", {text("the name of an exact solution")}, false, "", "see the list of exact solutions"},
           {"parameters",
            {named(number_or_path(), "the name of a parameter of the formula")},
            false,
            "{}",
            "its parameters: quantities, or paths of keys of the model"},
           {"table", one_or_more("the path of a CSV file, from here"), false, "",
            "a table for all levels, or one per level; its first column is the place [m], or the time [s] of a number"},
           {"column", {text("the name of a column")}, false, "the second", "of the table"},
           {"finest", {boolean()}, false, "false", "the same method at the last level"},
           {"method", {text("the name of a method")}, false, "", "its mean at the same level"},
           {"value", number_or_path(), false, "", "a value; beside `table`, what its column is multiplied by"}}};
}

}  // namespace

std::vector<Table> study_file_tables() {
  return {study_table(), method_table(), level_table(), quantity_table(), reference_table()};
}

}  // namespace shmoo::scene
