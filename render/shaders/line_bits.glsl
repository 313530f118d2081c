// Edges between pixels as bits. A tile of 4 by 4 pixels has two words, of the lines that run along rows and of those that
// run along columns. In either, the upper half says which pixels have such a line at their lower side (in columns: left),
// the lower half where lines of the other direction cross it: at which pixels' left side (in columns: lower). Four
// neighbours along the line are four bits.
//
//   bit of either half    12 13 14 15   across 3
//                          8  9 10 11   across 2
//                          4  5  6  7   across 1
//                          0  1  2  3   across 0      along 0…3

const uint k_half_word = 16u;
/// Of one row's bits.
const uint k_row_mask = 15u;

uint line_bit(int along, int across) {
    return 1u << uint(4 * across + along);
}

/// The bits of a half word mirrored at the diagonal: of columns where it was of rows.
uint transposed_bits(uint bits) {
    // Swaps the two off-diagonal bits of each 2 by 2 block, then the off-diagonal blocks.
    uint pairs = (bits ^ (bits >> 3u)) & 0x0a0au;
    bits ^= pairs ^ (pairs << 3u);
    uint blocks = (bits ^ (bits >> 6u)) & 0x00ccu;
    return bits ^ blocks ^ (blocks << 6u);
}

/// @param left, below  pixels with an edge on their left and below them
/// @return             words of rows (x) and of columns (y)
uvec2 packed_lines(uint left, uint below) {
    return uvec2(below << k_half_word | left, transposed_bits(left) << k_half_word | transposed_bits(below));
}
