namespace ErrorMatching.Nc;

/// <summary>Finds the targets of jumps in a file, each once.</summary>
/// <param name="program">The file.</param>
/// <param name="syntax">Its syntax.</param>
/// <param name="skips">True if blocks after a slash are skipped, so that they are no targets.</param>
internal sealed class TargetSearch(NcProgram program, NcSyntax syntax, bool skips)
{
    private readonly Dictionary<(int From, bool Forward, bool Backward, long Number, string Label), int> _targets = [];

    private const int BytesPerBlock = 64;

    /// <summary>The work of searching so far, in blocks with heads of usual length.</summary>
    public long Count { get; private set; }

    /// <summary>The block with a number, searched forward from a block and then from the start of the program; -1 if none.</summary>
    public int Number(FlowUnit unit, int from, long number, bool forward, bool backward) =>
        Find(unit, from, forward, backward, number, "");

    /// <summary>The block with a label, searched as for a number.</summary>
    public int Label(FlowUnit unit, int from, string label, bool forward, bool backward) =>
        Find(unit, from, forward, backward, -1, label);

    private int Find(FlowUnit unit, int from, bool forward, bool backward, long number, string label)
    {
        var key = (from, forward, backward, number, label);
        if (_targets.TryGetValue(key, out var known))
        {
            return known;
        }

        var found = forward ? Search(from + 1, unit.End, number, label) : -1;
        if (found < 0 && backward)
        {
            // A forward search continues from the top; a search only backward takes the nearest.
            found = forward ? Search(unit.First, from + 1, number, label) : SearchBack(unit.First, from, number, label);
        }

        return _targets[key] = found;
    }

    private int Search(int first, int end, long number, string label)
    {
        for (var i = first; i < end; i++)
        {
            if (IsTarget(i, number, label))
            {
                return i;
            }
        }

        return -1;
    }

    private int SearchBack(int first, int from, long number, string label)
    {
        for (var i = from; i >= first; i--)
        {
            if (IsTarget(i, number, label))
            {
                return i;
            }
        }

        return -1;
    }

    private bool IsTarget(int block, long number, string label)
    {
        var text = program.BytesOf(program[block]);
        var head = BlockHead.Read(text, syntax);
        Count += 1 + (head.At / BytesPerBlock);
        return skips && head.IsSkip ? false : label.Length == 0
            ? head.Number == number && number >= 0
            : head.LabelLength == label.Length
                && NcText.Decode(text.Slice(head.LabelAt, head.LabelLength)).Equals(label, StringComparison.OrdinalIgnoreCase);
    }
}
