using System.Numerics;

namespace ErrorMatching.Nc;

/// <summary>One bit for each of many positions, and how many are set before each: a fifth of a byte a position instead of an index of four.</summary>
internal sealed class RankedBits
{
    private ulong[] _bits = new ulong[16];
    private int[] _before = new int[16];
    private int _count;

    /// <summary>Appends a bit.</summary>
    public void Add(bool bit)
    {
        var word = _count >> 6;
        if ((_count & 63) == 0 && word > 0)
        {
            if (word == _bits.Length)
            {
                Array.Resize(ref _bits, word * 2);
                Array.Resize(ref _before, word * 2);
            }

            _before[word] = _before[word - 1] + BitOperations.PopCount(_bits[word - 1]);
        }

        _bits[word] |= (bit ? 1UL : 0) << (_count & 63);
        _count++;
    }

    /// <summary>How many bits are set up to a position, its own included.</summary>
    public int CountTo(int position) => _before[position >> 6] + BitOperations.PopCount(_bits[position >> 6] & (ulong.MaxValue >> (63 - (position & 63))));
}
