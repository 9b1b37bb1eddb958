using System.Buffers;
using System.Text;

namespace ErrorMatching.Json;

/// <summary>The line starts of a text, and whether it is UTF-8.</summary>
internal sealed class LineMap
{
    private readonly List<int> _starts = [0];
    private int _countedTo;
    private int _counted;

    public LineMap(ReadOnlySpan<byte> bytes)
    {
        for (var i = 0; i < bytes.Length; i++)
        {
            if (bytes[i] == (byte)'\n')
            {
                _starts.Add(i + 1);
            }
        }

        FirstInvalidByte = System.Text.Unicode.Utf8.IsValid(bytes) ? null : FindInvalid(bytes);
    }

    /// <summary>Index of the first byte that is not UTF-8; null if there is none.</summary>
    public int? FirstInvalidByte { get; }

    public JsonPlace PlaceOf(ReadOnlySpan<byte> bytes, long index)
    {
        var found = _starts.BinarySearch((int)index);
        var line = found >= 0 ? found : ~found - 1;
        return new(line + 1, CharactersBefore(bytes, _starts[line], (int)index) + 1);
    }

    /// <summary>The index of a byte in a line.</summary>
    /// <param name="line">The line, from 0.</param>
    /// <param name="byteInLine">The byte in it, from 0.</param>
    /// <param name="length">Length of the text, the largest index.</param>
    public int IndexOf(long line, long byteInLine, int length) =>
        (int)Math.Min(_starts[(int)Math.Min(line, _starts.Count - 1)] + byteInLine, length);

    // Places are queried from front to back, so that a document on one line is counted only once.
    private int CharactersBefore(ReadOnlySpan<byte> bytes, int start, int index)
    {
        _counted = _countedTo >= start && _countedTo <= index
            ? _counted + Characters(bytes[_countedTo..index])
            : Characters(bytes[start..index]);
        _countedTo = index;
        return _counted;
    }

    private static int Characters(ReadOnlySpan<byte> bytes)
    {
        var count = 0;
        foreach (var b in bytes)
        {
            count += (b & 0xC0) == 0x80 ? 0 : 1;
        }

        return count;
    }

    private static int FindInvalid(ReadOnlySpan<byte> bytes)
    {
        var at = 0;
        while (Rune.DecodeFromUtf8(bytes[at..], out _, out var consumed) == OperationStatus.Done)
        {
            at += consumed;
        }

        return at;
    }
}
