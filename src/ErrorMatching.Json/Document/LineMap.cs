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

    public JsonPlace PlaceOf(ReadOnlySpan<byte> bytes, long line, long byteInLine)
    {
        var start = _starts[(int)Math.Min(line, _starts.Count - 1)];
        return PlaceOf(bytes, Math.Min(start + byteInLine, bytes.Length));
    }

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
