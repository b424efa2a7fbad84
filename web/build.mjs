// Builds the page as one file, and as a C++ source that returns it: build.mjs PAGE.html [SOURCE.cpp]
// Nothing else is written, so that several builds may share the sources.
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

import { build } from 'vite';

const root = path.dirname(fileURLToPath(import.meta.url));
const [output, source] = process.argv.slice(2);
if (!output) {
  console.error('usage: build.mjs PAGE.html [SOURCE.cpp]');
  process.exit(2);
}

const result = await build({
  root,
  configFile: false,
  logLevel: 'warn',
  esbuild: { charset: 'ascii' },
  build: { write: false, target: 'es2022', modulePreload: false, assetsInlineLimit: 1e9, cssCodeSplit: false },
});
const files = new Map(result.output.map((file) => [file.fileName, file.type === 'chunk' ? file.code : String(file.source)]));

/** The text with what it refers to inside; whatever would end the element early is written another way. */
function inlined(page) {
  const file = (name) => files.get(name.replace(/^\//, ''));
  return page
    .replace(/\s*<link rel="stylesheet"[^>]*href="([^"]+)"[^>]*>/g, (_, name) => `\n<style>${file(name)}</style>`)
    .replace(/\s*<script type="module"[^>]*src="([^"]+)"[^>]*><\/script>/g, '')
    .replace('</body>', () => `<script type="module">${scripts(page).map(file).join('').replaceAll('</script', '<\\/script')}</script>\n</body>`);
}

function scripts(page) {
  return [...page.matchAll(/<script type="module"[^>]*src="([^"]+)"/g)].map((match) => match[1]);
}

/** Compilers promise literals of 65,536 bytes; ASCII alone, so that a cut never falls into a letter. */
function asSource(page) {
  const pieces = page.match(/[^]{1,16000}/g).map((piece) => `R"heed(${piece})heed"`);
  return `#include "play_template.h"

#include <string_view>

namespace heed::report {

std::string play_template() {
  constexpr std::string_view pieces[] = {${pieces.join(',\n')}};
  std::string page;
  for (const std::string_view piece : pieces) page += piece;
  return page;
}

}  // namespace heed::report
`;
}

function write(file, content) {
  mkdirSync(path.dirname(path.resolve(file)), { recursive: true });
  writeFileSync(file, content);
}

const page = inlined(files.get('index.html'));
if (/(src|href)="(?!data:)[^#"]/.test(page.replace(/<script type="module">[^]*/, ''))) throw new Error('the page refers to another file');
if (/[^\x00-\x7f]/.test(page)) throw new Error('the page is not ASCII: write such letters as escapes');
write(output, page);
if (source) write(source, asSource(page));
