using System.Buffers.Binary;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The characters that a face has, from its <c>cmap</c> table (OpenType 1.9, formats 4 and 12).</summary>
internal sealed class CharacterMap
{
    private readonly byte[] _table;
    private readonly int _wide = -1, _narrow = -1;

    /// <summary>Finds the subtables for Unicode. A table that has none, or is cut off, has no characters.</summary>
    public CharacterMap(byte[] table)
    {
        _table = table;
        for (var i = 0; i < Short(2); i++)
        {
            var (platform, encoding, at) = (Short(4 + (8 * i)), Short(6 + (8 * i)), (int)Math.Min(int.MaxValue / 2, Long(8 + (8 * i))));
            if (platform is 0 || (platform is 3 && encoding is 1 or 10))
            {
                (_wide, _narrow) = Short(at) switch { 12 => (at, _narrow), 4 => (_wide, at), _ => (_wide, _narrow) };
            }
        }
    }

    /// <summary>True if the face has a glyph for a character.</summary>
    public bool Has(int character) =>
        (_wide >= 0 && InGroups(character)) || (_narrow >= 0 && character <= ushort.MaxValue && InSegments(character));

    // Groups of consecutive characters, sorted: first, last, glyph of the first.
    private bool InGroups(int character)
    {
        var (low, high) = (0L, (long)Long(_wide + 12) - 1);
        while (low <= high)
        {
            var middle = (low + high) / 2;
            var at = _wide + 16 + (12 * middle);
            if (at + 12 > _table.Length || character < Long((int)at))
            {
                high = middle - 1;
            }
            else if (character > Long((int)at + 4))
            {
                low = middle + 1;
            }
            else
            {
                return Long((int)at + 8) + (character - Long((int)at)) != 0;
            }
        }

        return false;
    }

    // Segments in four parallel arrays: ends, starts, differences, and places in the list of glyphs.
    private bool InSegments(int character)
    {
        var doubled = Short(_narrow + 6);
        for (var i = 0; i < doubled; i += 2)
        {
            var ends = _narrow + 14;
            var (end, start) = (Short(ends + i), Short(ends + doubled + 2 + i));
            if (character <= end)
            {
                var (difference, place) = (Short(ends + (2 * doubled) + 2 + i), ends + (3 * doubled) + 2 + i);
                var glyph = character < start ? 0
                    : Short(place) == 0 ? character + difference
                    : Short(place + Short(place) + (2 * (character - start))) is var listed and not 0 ? listed + difference : 0;
                return (glyph & ushort.MaxValue) != 0;
            }
        }

        return false;
    }

    private int Short(int at) => at + 2 <= _table.Length ? BinaryPrimitives.ReadUInt16BigEndian(_table.AsSpan(at)) : 0;

    private uint Long(int at) => at + 4 <= _table.Length ? BinaryPrimitives.ReadUInt32BigEndian(_table.AsSpan(at)) : 0;
}
