declare module "snug.wasm?url" {
    const url: string;
    export default url;
}
