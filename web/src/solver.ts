// The solver: loaded once, compiled once, and handed to the workers, which load its glue from the same file.
import type load from "snug";
import type { Snug } from "snug";
import glueUrl from "snug.mjs?url";
import wasmUrl from "snug.wasm?url";

export async function compile(): Promise<WebAssembly.Module> {
    const response = await fetch(wasmUrl);
    if (!response.ok) throw new Error(`the solver could not be loaded (${response.status})`);
    return WebAssembly.compile(await response.arrayBuffer());
}

export async function start(module: WebAssembly.Module): Promise<Snug> {
    const glue = (await import(/* @vite-ignore */ new URL(glueUrl, import.meta.url).href)) as { default: typeof load };
    return glue.default({
        instantiateWasm(imports, done) {
            void WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
            return {};
        },
    });
}
