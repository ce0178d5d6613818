// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "tests/architecture/house_files.h"

namespace {

namespace house = plumbline::house;
using house::File;
using Lines = std::vector<std::string>;

const std::filesystem::path root = PLUMBLINE_SOURCE_DIR;

}  // namespace

TEST_CASE("no include breaks the order of the layers", "[architecture]") {
    CHECK(house::layer_violations(house::house_files(root)) == Lines{});
}

TEST_CASE("an include that breaks the order of the layers is found", "[architecture]") {
    const auto violations = [](const std::string& path, const std::string& text) {
        return house::layer_violations({File{path, text}}).size();
    };
    CHECK(violations("ddgi/model.cpp", "#include \"scenes/scene.h\"\n#include <vector>\n") == 0);
    CHECK(violations("ddgi/model.cpp", "#include \"pathtracer/render.h\"\n") == 1);
    CHECK(violations("pathtracer/render.cpp", "  #  include <ddgi/render.h>\n") == 1);
    CHECK(violations("compare/fit.cpp", "#include \"ddgi/render.h\"\n") == 0);
    CHECK(violations("compare/fit.cpp", "#include \"pathtracer/render.h\"\n") == 1);
    CHECK(violations("scenes/world.h", "#include \"compare/fit.h\"\n") == 1);
    CHECK(violations("reports/report.cpp", "#include \"tests/scenes/boxes.h\"\n") == 1);
    CHECK(violations("plumbline.cpp", "#include \"reports/commands.h\"\n") == 0);
    CHECK(violations("ddgi/model.cpp", "#include \"../pathtracer/render.h\"\n") == 1);
}

TEST_CASE("the root has the folders of the house and no other", "[architecture]") {
    std::set<std::string> expected;
    for (const auto& [folder, allowed] : house::may_include) expected.insert(folder);
    CHECK(house::top_level_folders(root) == expected);
}

TEST_CASE("every file has its license line and ends well", "[architecture]") {
    CHECK(house::form_violations(house::house_files(root)) == Lines{});
}

TEST_CASE("a file without license line, or with a bad end, is found", "[architecture]") {
    const std::string license = "// SPDX-License-Identifier: Apache-2.0\n";
    const auto violations = [](const std::string& path, const std::string& text) {
        return house::form_violations({File{path, text}}).size();
    };
    CHECK(violations("ddgi/model.cpp", license + "int x;\n") == 0);
    CHECK(violations("ddgi/model.cpp", "int x;\n" + license) == 1);
    CHECK(violations("ddgi/model.cpp", license + "int x;") == 1);
    CHECK(violations("ddgi/model.cpp", license + "int x;\r\n") == 1);
    CHECK(violations("ddgi/model.cpp", license + "int x;\n\n") == 1);
    CHECK(violations("ddgi/model.hpp", license) == 1);
    CHECK(violations("run", "#!/bin/bash\n# SPDX-License-Identifier: Apache-2.0\n") == 0);
    CHECK(violations("run", "#!/bin/bash\n") == 1);
}

TEST_CASE("no file is compiled with options that forget NaN", "[architecture]") {
    const std::string text = house::read_file(PLUMBLINE_BUILD_DIR, "compile_commands.json").text;
    REQUIRE(text.find("plumbline.cpp") != std::string::npos);
    CHECK(house::unsafe_math_options(text) == Lines{});
    for (const File& file : house::house_files(root)) {
        // These tests have to name the options.
        if (file.folder() == "tests") continue;
        INFO(file.path);
        CHECK(house::unsafe_math_options(file.text) == Lines{});
    }
}

TEST_CASE("an option that forgets NaN is found", "[architecture]") {
    CHECK(house::unsafe_math_options("c++ -O2 -fno-math-errno -c a.cpp") == Lines{});
    CHECK(house::unsafe_math_options("c++ -Ofast -c a.cpp") == Lines{"-Ofast"});
    CHECK(house::unsafe_math_options("set(flags \"-ffast-math\")") == Lines{"-ffast-math"});
}

TEST_CASE("every source that the code cites is in the README's list", "[architecture]") {
    const std::string readme = house::read_file(root, "README.md").text;
    CHECK(house::sources_without_entry(house::house_files(root), readme) ==
          std::set<std::string>{});
}

TEST_CASE("a source that is missing in the README's list is found", "[architecture]") {
    // Put together here, so that this file cites nothing.
    const std::string known = "Rayleigh 1900";
    const std::string unknown = "Abel and Cain 1900";
    const File file{"ddgi/model.h", "/// [" + known + ", eq. 2] and [" + unknown + "]"};
    CHECK(house::sources_without_entry({file}, "**[" + known + "]** Title.") ==
          std::set<std::string>{unknown});
}

TEST_CASE("no test has a name that keeps it from being run", "[architecture]") {
    CHECK(house::unrunnable_test_names(house::house_files(root)) == Lines{});
}

TEST_CASE("a test name that would keep tests from being run is found", "[architecture]") {
    const auto names = [](const std::string& name) {
        return house::unrunnable_test_names({File{"tests/a.cpp", "TEST_CASE(" + name + ", x)"}});
    };
    CHECK(names("\"all is well, and (so) on\"") == Lines{});
    CHECK(names("\"in [0, 1)\"") == Lines{"in [0, 1)"});
    CHECK(names("\"one; two\"") == Lines{"one; two"});
}
