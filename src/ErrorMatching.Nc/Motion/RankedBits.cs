using System.Numerics;
using System.Runtime.CompilerServices;

namespace ErrorMatching.Nc;

/// <summary>One bit per position, and the number of bits set before each: a fifth of a byte per position instead of a four-byte
/// index.</summary>
internal sealed class RankedBits
{
    private ulong[] _bits = new ulong[16];
    private int[] _before = new int[16];
    private int _count;

    /// <summary>Appends a bit.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(bool bit)
    {
        var word = _count >> 6;
        if ((_count & 63) == 0 && word > 0)
        {
            Begin(word);
        }

        _bits[word] |= (bit ? 1UL : 0) << (_count & 63);
        _count++;
    }

    /// <summary>Appends the bits of another list from a position up to, not including, another.</summary>
    public void AddFrom(RankedBits other, int position, int end)
    {
        // Bit by bit up to a word boundary of the other list, then word by word, each in two parts.
        for (; (position & 63) != 0 && position < end; position++)
        {
            Add(other[position]);
        }

        for (; position < end; position += 64)
        {
            var rest = Math.Min(64, end - position);
            var bits = other._bits[position >> 6] & (ulong.MaxValue >> (64 - rest));
            while (rest > 0)
            {
                var (word, at) = (_count >> 6, _count & 63);
                if (at == 0 && word > 0)
                {
                    Begin(word);
                }

                var part = Math.Min(rest, 64 - at);
                _bits[word] |= bits << at;
                bits = part < 64 ? bits >> part : 0;
                (_count, rest) = (_count + part, rest - part);
            }
        }
    }

    private void Begin(int word)
    {
        if (word == _bits.Length)
        {
            Array.Resize(ref _bits, word * 2);
            Array.Resize(ref _before, word * 2);
        }

        _before[word] = _before[word - 1] + BitOperations.PopCount(_bits[word - 1]);
    }

    /// <summary>The bit at a position.</summary>
    public bool this[int position] => (_bits[position >> 6] >> (position & 63) & 1) != 0;

    /// <summary>True if both have the same bits.</summary>
    public bool SameAs(RankedBits other) => _count == other._count && Words.SequenceEqual(other.Words);

    private ReadOnlySpan<ulong> Words => _bits.AsSpan(0, (_count + 63) >> 6);

    /// <summary>Number of bits set up to and including a position.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int CountTo(int position) =>
        _before[position >> 6] + BitOperations.PopCount(_bits[position >> 6] & (ulong.MaxValue >> (63 - (position & 63))));
}
