/* state.S -- the saved rules (Prolog state) as bytes of the program. */
	.section .rodata
	.global sg_state, sg_state_end
	.balign 16
sg_state:
	.incbin SG_STATE
sg_state_end:
	.section .note.GNU-stack,"",@progbits
