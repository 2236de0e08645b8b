// Two static pages; the solver comes from build/wasm, where bindings/wasm puts it.
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const file = (path) => fileURLToPath(new URL(path, import.meta.url));
const solver = process.env.SNUG_WASM ?? file("../build/wasm");

export default defineConfig({
    base: "./",
    resolve: {
        alias: [
            { find: /^snug$/, replacement: `${solver}/snug.mjs` },
            { find: /^snug\.wasm/, replacement: `${solver}/snug.wasm` },
        ],
    },
    build: {
        target: "es2022",
        assetsInlineLimit: 0,
        modulePreload: { polyfill: false },
        rollupOptions: { input: { index: file("index.html"), story: file("story.html") } },
    },
    worker: { format: "es" },
    server: { host: "127.0.0.1", fs: { allow: [file(".."), solver] } },
    preview: { host: "127.0.0.1" },
});
