// The solver: loaded once, compiled once, and handed to the workers.
import load, { type Snug } from "snug";
import wasmUrl from "snug.wasm?url";

export async function compile(): Promise<WebAssembly.Module> {
    const response = await fetch(wasmUrl);
    if (!response.ok) throw new Error(`the solver could not be loaded (${response.status})`);
    return WebAssembly.compile(await response.arrayBuffer());
}

export function start(module: WebAssembly.Module): Promise<Snug> {
    return load({
        instantiateWasm(imports, done) {
            void WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
            return {};
        },
    });
}
