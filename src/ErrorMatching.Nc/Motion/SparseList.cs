using System.Numerics;

namespace ErrorMatching.Nc;

/// <summary>Values for some of many positions: memory pages only where there are values, and one bit per position.</summary>
internal sealed class SparseList<T>
    where T : struct
{
    private const int Shift = 9;
    private const int Size = 1 << Shift;

    private readonly T[]?[] _pages;
    private readonly ulong[] _isSet;

    /// <summary>Creates an empty list.</summary>
    /// <param name="length">Number of positions.</param>
    public SparseList(int length)
    {
        _pages = new T[]?[(length >> Shift) + 1];
        _isSet = new ulong[(length >> 6) + 1];
    }

    /// <summary>Number of positions with a value.</summary>
    public int Count { get; private set; }

    /// <summary>The value at a position; the type's default if it has none.</summary>
    public T this[int position]
    {
        get => _pages[position >> Shift] is { } page ? page[position & (Size - 1)] : default;
        set
        {
            Count += Has(position) ? 0 : 1;
            _isSet[position >> 6] |= 1UL << (position & 63);
            (_pages[position >> Shift] ??= new T[Size])[position & (Size - 1)] = value;
        }
    }

    /// <summary>True if a position has a value.</summary>
    public bool Has(int position) => (_isSet[position >> 6] >> (position & 63) & 1) != 0;

    /// <summary>The positions with a value, ascending.</summary>
    public IEnumerable<int> Positions()
    {
        for (var word = 0; word < _isSet.Length; word++)
        {
            for (var rest = _isSet[word]; rest != 0; rest &= rest - 1)
            {
                yield return (word << 6) + BitOperations.TrailingZeroCount(rest);
            }
        }
    }
}
