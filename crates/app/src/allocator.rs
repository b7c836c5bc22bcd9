//! Global allocator of the page: the allocator of the standard library, but never inlined.
//!
//! The allocator stores the size of a block in the word before the block. If the allocator is inlined, the optimiser treats this word as part of the
//! zeroed block and sets it to zero. The block then has size 0 when it is freed, and the page crashes.
#![allow(unsafe_code)] // A global allocator is unsafe by its trait; every call goes to the standard library's.

use std::alloc::{GlobalAlloc, Layout, System};

struct Apart;

// SAFETY: each function passes its arguments to the system allocator, which fulfils the contract of the trait.
unsafe impl GlobalAlloc for Apart {
    #[inline(never)]
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        unsafe { System.alloc(layout) }
    }

    #[inline(never)]
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        unsafe { System.alloc_zeroed(layout) }
    }

    #[inline(never)]
    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        unsafe { System.dealloc(block, layout) }
    }

    #[inline(never)]
    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        unsafe { System.realloc(block, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Apart = Apart;
