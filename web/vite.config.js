// Two static pages; the solver comes from build/wasm, where bindings/wasm puts it.
import { fileURLToPath } from "node:url";
import { defineConfig, transformWithEsbuild } from "vite";

const file = (path) => fileURLToPath(new URL(path, import.meta.url));
const solver = process.env.SNUG_WASM ?? file("../build/wasm");

/** The solver's glue is a file of its own, which page and workers load: rollup does not see into it. */
const minifiedGlue = {
    name: "minified-glue",
    async generateBundle(_, bundle) {
        for (const file of Object.values(bundle))
            if (file.fileName.endsWith(".mjs")) file.source = (await transformWithEsbuild(String(file.source), file.fileName, { minify: true })).code;
    },
};

/** The solver is on its way before the page's own script has been read. */
const preloaded = {
    name: "preloaded",
    transformIndexHtml: {
        order: "post",
        handler: (_, { bundle, filename }) =>
            Object.keys(filename.endsWith("index.html") ? (bundle ?? {}) : {}).flatMap((name) => {
                const tag = (attrs) => [{ tag: "link", attrs: { ...attrs, href: `./${name}`, crossorigin: "" }, injectTo: "head" }];
                if (name.endsWith(".wasm")) return tag({ rel: "preload", as: "fetch", type: "application/wasm" });
                return name.endsWith(".mjs") ? tag({ rel: "modulepreload" }) : [];
            }),
    },
};

export default defineConfig({
    base: "./",
    plugins: [minifiedGlue, preloaded, { name: "no-indentation", transformIndexHtml: (html) => html.replace(/\n\s+/g, "\n") }],
    resolve: {
        alias: [
            { find: /^snug\.mjs/, replacement: `${solver}/snug.mjs` },
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
