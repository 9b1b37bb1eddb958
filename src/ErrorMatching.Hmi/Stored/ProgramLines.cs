using System.Collections;
using System.Globalization;
using ErrorMatching.Mating;
using ErrorMatching.Nc;

namespace ErrorMatching.Hmi;

/// <summary>Two programs side by side, line by line. A line becomes text only when shown, so a program of a million blocks costs
/// no more than its bytes.</summary>
/// <remarks>A list for a virtualizing view. It aligns only changed and inserted blocks, because rewriting makes no other changes.</remarks>
internal sealed class ProgramLines : IList, IReadOnlyList<ProgramLine>
{
    private readonly NcProgram _original;
    private readonly NcProgram _modified;
    private readonly Dictionary<int, ReportBlock> _changed;
    private readonly int[] _inserted;

    /// <summary>Aligns two programs.</summary>
    /// <param name="original">The bytes of the original program.</param>
    /// <param name="modified">The bytes of the new program.</param>
    /// <param name="blocks">The report's changed blocks.</param>
    /// <param name="marker">The inserted comment that tells the origin of the new program; null if there is none.</param>
    public ProgramLines(
        ReadOnlyMemory<byte> original, ReadOnlyMemory<byte> modified, IReadOnlyList<ReportBlock> blocks, string? marker = null)
    {
        (_original, _modified, Modified, Bytes) = (NcProgram.Read(original), NcProgram.Read(modified), modified, modified.Length);
        _changed = blocks.Where(b => b.Original.Length > 0).ToDictionary(b => b.Line - 1);
        _inserted = [.. Inserted()];
        Changes = [.. _changed.Keys.Select(RowOf).Concat(_inserted.Where(i => Text(_modified, i).Trim() != marker?.Trim())).Order()];
    }

    /// <summary>Indexes of the lines that differ, without the marker, which changes no motion.</summary>
    public IReadOnlyList<int> Changes { get; }

    /// <summary>The new program.</summary>
    public ReadOnlyMemory<byte> Modified { get; }

    /// <summary>Length of the new program.</summary>
    public long Bytes { get; }

    /// <inheritdoc cref="ICollection.Count"/>
    public int Count => _original.BlockCount + _inserted.Length;

    /// <inheritdoc/>
    public bool IsFixedSize => true;

    /// <inheritdoc/>
    public bool IsReadOnly => true;

    /// <inheritdoc/>
    public bool IsSynchronized => false;

    /// <inheritdoc/>
    public object SyncRoot => this;

    public ProgramLine this[int index]
    {
        get
        {
            ArgumentOutOfRangeException.ThrowIfNegative(index);
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(index, Count);
            var place = Array.BinarySearch(_inserted, index);
            if (place >= 0)
            {
                var text = Text(_modified, index);
                return new(index, null, "", text, [], [new(0, text.Length)]);
            }

            var block = index - ~place;
            return _changed.TryGetValue(block, out var change)
                ? new(index, block, Text(_original, block), Text(_modified, index), change.OriginalSpans, change.ModifiedSpans)
                : new(index, block, Text(_original, block), Text(_modified, index), [], []);
        }
    }

    object? IList.this[int index]
    {
        get => this[index];
        set => throw new NotSupportedException();
    }

    /// <inheritdoc/>
    public IEnumerator<ProgramLine> GetEnumerator()
    {
        for (var i = 0; i < Count; i++)
        {
            yield return this[i];
        }
    }

    /// <inheritdoc/>
    public int IndexOf(object? value) => value is ProgramLine line ? line.Index : -1;

    /// <inheritdoc/>
    public bool Contains(object? value) => IndexOf(value) >= 0;

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    int IList.Add(object? value) => throw new NotSupportedException();

    void IList.Clear() => throw new NotSupportedException();

    void IList.Insert(int index, object? value) => throw new NotSupportedException();

    void IList.Remove(object? value) => throw new NotSupportedException();

    void IList.RemoveAt(int index) => throw new NotSupportedException();

    void ICollection.CopyTo(Array array, int index) => throw new NotSupportedException();

    /// <summary>The next line, after the last one the first again, that is what somebody looks for: a block by its number (<c>N120</c>),
    /// a line by its number in the new program (<c>35</c>), or a text in either program, in capital or small letters.</summary>
    /// <param name="words">What to look for.</param>
    /// <param name="from">The line before the first one to look at; -1 for none.</param>
    /// <param name="step">1 to go down, -1 to go up.</param>
    /// <returns>Its index; null if there is none.</returns>
    public int? Find(string words, int from, int step)
    {
        words = words.Trim();
        if (words.Length == 0 || Count == 0)
        {
            return null;
        }

        if (int.TryParse(words, NumberStyles.None, CultureInfo.InvariantCulture, out var line))
        {
            return line >= 1 && line <= Count ? line - 1 : null;
        }

        var number = BlockNumber(words);
        for (var (i, looked) = (from < 0 && step < 0 ? 0 : from, 0); looked < Count; looked++)
        {
            i = (i + step + Count) % Count;
            var (modified, place) = (Text(_modified, i), Array.BinarySearch(_inserted, i));
            var original = place >= 0 ? "" : Text(_original, i - ~place);
            if (number is { } n && words.Length == number.Length + 1
                ? BlockNumber(modified) == n
                : modified.Contains(words, StringComparison.OrdinalIgnoreCase)
                    || original.Contains(words, StringComparison.OrdinalIgnoreCase))
            {
                return i;
            }
        }

        return null;
    }

    // The digits of the number that a block begins with, also behind a slash; null without one.
    private static string? BlockNumber(string block)
    {
        var text = block.AsSpan().TrimStart("/ \t");
        if (text.IsEmpty || text[0] is not ('N' or 'n'))
        {
            return null;
        }

        var digits = text[1..];
        var end = digits.IndexOfAnyExceptInRange('0', '9');
        digits = end < 0 ? digits : digits[..end];
        return digits.IsEmpty ? null : digits.ToString();
    }

    // One character per byte, so that the report's spans match.
    private static string Text(NcProgram program, int block) => System.Text.Encoding.Latin1.GetString(program.BytesOf(program[block]));

    // Blocks that only the new program has: it has that many more blocks than the original.
    private IEnumerable<int> Inserted()
    {
        var more = _modified.BlockCount - _original.BlockCount;
        for (var (was, now) = (0, 0); more > 0 && now < _modified.BlockCount; now++)
        {
            var isSame = was < _original.BlockCount
                && (_changed.ContainsKey(was) || _original.BytesOf(_original[was]).SequenceEqual(_modified.BytesOf(_modified[now])));
            if (isSame)
            {
                was++;
            }
            else
            {
                more--;
                yield return now;
            }
        }
    }

    private int RowOf(int block) => block + _inserted.TakeWhile((row, i) => row <= block + i).Count();
}

/// <summary>A line of two programs side by side.</summary>
/// <param name="Index">Its index in the list, from 0. Rewriting removes no line, so this is also its index in the new program.</param>
/// <param name="Block">Its index in the original, from 0; null if the line is inserted.</param>
/// <param name="Original">The original text; empty if the line is inserted.</param>
/// <param name="Modified">The new text.</param>
/// <param name="OriginalSpans">Replaced spans.</param>
/// <param name="ModifiedSpans">New spans.</param>
internal sealed record ProgramLine(
    int Index,
    int? Block,
    string Original,
    string Modified,
    IReadOnlyList<TextSpan> OriginalSpans,
    IReadOnlyList<TextSpan> ModifiedSpans)
{
    /// <summary>Its line number in the new program, from 1, as the control's screen counts.</summary>
    public string Number => Shown.Id(Index + 1);

    /// <summary>Its line number in the original, from 1; empty if the line is inserted.</summary>
    public string OriginalNumber => Block is { } block ? Shown.Id(block + 1) : "";

    /// <summary>True if the line is changed or inserted.</summary>
    public bool IsChanged => ModifiedSpans.Count > 0;
}
