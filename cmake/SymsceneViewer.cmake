# Builds the viewer's pages with npm, in the build folder, and embeds them into symscene_viewer.
# Include after symscene_library(viewer ...).
include(SymsceneEmbed)
set(SYMSCENE_VIEWER_PAGE "" CACHE FILEPATH "A built viewer/dist/page.html with review.html, run.html and live.html beside it, to build without Node and npm")

# Sets `page` to the path of the built page, with the others beside it, and adds the commands that make them.
function(symscene_build_page page)
  find_program(SYMSCENE_NODE NAMES node nodejs REQUIRED)
  find_program(SYMSCENE_NPM npm REQUIRED)
  set(source ${PROJECT_SOURCE_DIR}/viewer)
  set(work ${PROJECT_BINARY_DIR}/viewer)
  set(packages ${source}/package.json ${source}/package-lock.json ${source}/.npmrc)
  file(GLOB_RECURSE inputs CONFIGURE_DEPENDS ${source}/src/*)
  list(APPEND inputs ${source}/template.html ${source}/build.mjs)
  add_custom_command(OUTPUT ${work}/packages.stamp
    COMMAND ${CMAKE_COMMAND} -E make_directory ${work}
    COMMAND ${CMAKE_COMMAND} -E copy ${packages} ${work}
    # esbuild's install script only checks what npm has put there already.
    COMMAND ${CMAKE_COMMAND} -E chdir ${work}
      ${SYMSCENE_NPM} ci --omit=dev --ignore-scripts --prefer-offline --no-audit --no-fund --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${work}/packages.stamp
    DEPENDS ${packages} COMMENT "Fetching three.js and esbuild" VERBATIM)
  add_custom_command(OUTPUT ${work}/dist/page.html ${work}/dist/review.html ${work}/dist/run.html ${work}/dist/live.html
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${work}/src
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${source}/src ${work}/src
    COMMAND ${CMAKE_COMMAND} -E copy ${source}/template.html ${source}/build.mjs ${work}
    COMMAND ${CMAKE_COMMAND} -E chdir ${work} ${SYMSCENE_NODE} build.mjs
    DEPENDS ${inputs} ${work}/packages.stamp COMMENT "Bundling the viewer's pages" VERBATIM)
  set(${page} ${work}/dist/page.html PARENT_SCOPE)
endfunction()

function(symscene_embed_pages target)
  if(SYMSCENE_VIEWER_PAGE)
    set(page ${SYMSCENE_VIEWER_PAGE})
  else()
    symscene_build_page(page)
  endif()
  cmake_path(GET page PARENT_PATH dist)
  symscene_embed(${target} ${page} page_template)
  symscene_embed(${target} ${dist}/review.html review_template)
  symscene_embed(${target} ${dist}/run.html run_template)
  symscene_embed(${target} ${dist}/live.html live_template)
endfunction()

if(TARGET symscene_viewer)
  symscene_embed_pages(symscene_viewer)
endif()
