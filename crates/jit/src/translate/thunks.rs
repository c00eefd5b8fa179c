//! Thunks that preserve all registers, between machine code and Rust code that is called seldom: a runtime call in cold code costs the hot
//! code around it no register. The result is in the runtime frame.

use std::mem::offset_of;

use cranelift_codegen::Context;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, Signature, Value};
use cranelift_codegen::isa::CallConv;
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::JITModule;
use cranelift_module::{FuncId, Linkage, Module, ModuleError};

use super::symbols::{Functions, Symbol};
use super::{TRUSTED, Translator, words_signature};
use crate::run::Run;
use crate::runtime_calls::RuntimeCall;

fn signature(module: &JITModule, question: RuntimeCall) -> Signature {
    let mut signature = words_signature(module, question.ask().arguments);
    signature.returns.clear();
    signature.call_conv = CallConv::PreserveAll;
    signature
}

/// Names the gate of a question.
pub(super) fn declare(module: &mut JITModule, question: RuntimeCall) -> Result<FuncId, Box<ModuleError>> {
    let signature = signature(module, question);
    module.declare_function(&format!("gate_{}", question.ask().name), Linkage::Local, &signature).map_err(Box::new)
}

/// Writes the gates that code uses; their bytes.
pub(super) fn define(
    module: &mut JITModule,
    functions: &Functions,
    context: &mut Context,
    frontend: &mut FunctionBuilderContext,
) -> Result<usize, Box<ModuleError>> {
    let mut bytes = 0;
    for question in functions.at_gates() {
        context.func.signature = signature(module, question);
        let mut b = FunctionBuilder::new(&mut context.func, frontend);
        let entry = b.create_block();
        b.append_block_params_for_function_params(entry);
        b.switch_to_block(entry);
        b.seal_block(entry);
        let arguments = b.block_params(entry).to_vec();
        let function = functions.get(module, Symbol::Question(question));
        let function = module.declare_func_in_func(function, b.func);
        let call = b.ins().call(function, &arguments);
        let answer = b.inst_results(call)[0];
        b.ins().store(TRUSTED, answer, arguments[0], offset_of!(Run<'_, '_>, answer) as i32);
        b.ins().return_(&[]);
        b.finalize(module.target_config());
        let gate = functions.get(module, Symbol::Gate(question));
        module.define_function(gate, context)?;
        bytes += context.compiled_code().map_or(0, |code| code.code_buffer().len());
        module.clear_context(context);
    }
    Ok(bytes)
}

impl Translator<'_> {
    /// Asks in cold code, through a gate; the answer.
    pub(super) fn ask_at_gate(&mut self, question: RuntimeCall, arguments: &[Value]) -> Value {
        let gate = self.functions.get(self.module, Symbol::Gate(question));
        let reference = self.reference(gate);
        self.b.ins().call(reference, arguments);
        self.b.ins().load(I64, TRUSTED, self.run, offset_of!(Run<'_, '_>, answer) as i32)
    }
}
