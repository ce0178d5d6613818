# SPDX-License-Identifier: Apache-2.0
# plumbline_embed(FOLDER FILE...) puts text files into the library plumbline_FOLDER, which then has
#     std::span<const EmbeddedFile> plumbline::embedded_FOLDER_files();
# As a script (cmake -P) this same file writes the source that holds them.
if(CMAKE_SCRIPT_MODE_FILE)
    set(entries "")
    foreach(file IN LISTS FILES)
        get_filename_component(name ${file} NAME)
        file(READ ${file} text)
        string(APPEND entries "    {\"${name}\", R\"embedded(${text})embedded\"},\n")
    endforeach()
    file(WRITE ${OUTPUT}
        "#include <array>\n#include <span>\n\n#include \"scenes/embedded_files.h\"\n\n"
        "namespace plumbline {\n\nnamespace {\n\nconstexpr auto files = std::to_array<EmbeddedFile>({\n"
        "${entries}});\n\n}  // namespace\n\n"
        "std::span<const EmbeddedFile> embedded_${FOLDER}_files();\n"
        "std::span<const EmbeddedFile> embedded_${FOLDER}_files() { return files; }\n\n}  // namespace plumbline\n")
    return()
endif()

set(plumbline_embed_script ${CMAKE_CURRENT_LIST_FILE})

function(plumbline_embed folder)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded_${folder}_files.cpp)
    add_custom_command(
        OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} "-DFILES=${ARGN}" -DFOLDER=${folder} -DOUTPUT=${output}
                -P ${plumbline_embed_script}
        DEPENDS ${ARGN} ${plumbline_embed_script}
        VERBATIM)
    target_sources(plumbline_${folder} PRIVATE ${output})
endfunction()
