// The solver: loaded once, compiled once, and handed to the workers, which load its glue from the same file.
import type load from "snug";
import type { Snug } from "snug";
import glueUrl from "snug.mjs?url";
import wasmUrl from "snug.wasm?url";

const glue = () => import(/* @vite-ignore */ new URL(glueUrl, import.meta.url).href) as Promise<{ default: typeof load }>;

export async function compile(): Promise<WebAssembly.Module> {
    void glue().catch(() => {}); // meanwhile; start() says what is wrong with it
    const response = await fetch(wasmUrl);
    if (!response.ok) throw new Error(`the solver could not be loaded (${response.status})`);
    // While it still comes in, where the server says what it is.
    if (response.headers.get("content-type") === "application/wasm") return WebAssembly.compileStreaming(response);
    return WebAssembly.compile(await response.arrayBuffer());
}

export async function start(module: WebAssembly.Module): Promise<Snug> {
    return (await glue()).default({
        instantiateWasm(imports, done) {
            void WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
            return {};
        },
    });
}
