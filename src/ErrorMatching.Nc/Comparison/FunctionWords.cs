using System.Text;

namespace ErrorMatching.Nc;

/// <summary>The words of some blocks that are not compared as motions. Excludes block numbers, coordinates of a motion, feeds, codes that
/// determine the meaning of coordinates, and comments.</summary>
internal sealed class FunctionWords(NcPath path)
{
    private readonly List<Word> _words = [];

    /// <summary>The words, in order.</summary>
    public IReadOnlyList<string> Texts => [
        .. _words.Select(
            w => w.Letter != 0
                ? $"{(char)w.Letter}{w.Number}"
                : NcText.Decode(path.Program.Bytes.Span.Slice(w.Start, w.Length)).ToUpperInvariant())];

    /// <summary>Collects the words of a motion's block and of the blocks since the motion before it. For the position after the last
    /// motion, collects those of the remaining blocks.</summary>
    public void Collect(int motion)
    {
        _words.Clear();
        var (first, last) = Blocks(motion);
        for (var block = first; block <= last; block++)
        {
            var moves = motion < path.Motions.Length && block == last;
            Collect(path.Program[block], moves, moves && path.Motions[motion].IsArc);
        }
    }

    /// <summary>The bytes of the blocks that <see cref="Collect(int)"/> reads.</summary>
    public ReadOnlySpan<byte> Bytes(int motion)
    {
        var (first, last) = Blocks(motion);
        return first > last ? [] : path.Program.Bytes.Span[path.Program[first].Start..path.Program[last].End];
    }

    /// <summary>True if both collected the same words.</summary>
    public bool SameAs(FunctionWords other)
    {
        if (_words.Count != other._words.Count)
        {
            return false;
        }

        for (var i = 0; i < _words.Count; i++)
        {
            var (a, b) = (_words[i], other._words[i]);
            if (a.Letter != b.Letter
                || a.Number != b.Number
                || (a.Letter == 0 && !Ascii.EqualsIgnoreCase(path.Program.Bytes.Span.Slice(a.Start, a.Length), other.Text(b))))
            {
                return false;
            }
        }

        return true;
    }

    private ReadOnlySpan<byte> Text(Word word) => path.Program.Bytes.Span.Slice(word.Start, word.Length);

    private (int First, int Last) Blocks(int motion) =>
        (
            motion > 0 ? path.Motions[motion - 1].Block + 1 : 0,
            motion < path.Motions.Length ? path.Motions[motion].Block : path.Program.BlockCount - 1);

    private void Collect(NcBlock block, bool moves, bool turns)
    {
        var dwells = false;
        foreach (var token in path.Program.Tokens(block))
        {
            dwells |= token is { Kind: NcTokenKind.Word, Letter: (byte)'G' } && Meaning(token) == NcMeaning.Dwell;
        }

        foreach (var token in path.Program.Tokens(block))
        {
            if (token.Kind == NcTokenKind.Word
                ? IsFunction(token, moves, turns, dwells)
                : token.Kind is not (NcTokenKind.Space or NcTokenKind.Comment or NcTokenKind.Percent))
            {
                _words.Add(
                    token.Kind == NcTokenKind.Word
                        ? new(token.Letter, token.Number.Trim(), token.Start, token.Length)
                        : new(0, default, token.Start, token.Length));
            }
        }
    }

    private bool IsFunction(NcToken token, bool moves, bool turns, bool dwells) => path.Dialect.RoleOf(token.Letter) switch
    {
        LetterRole.Number => false,
        LetterRole.Feed => dwells,
        LetterRole.Axis => !moves,
        LetterRole.Center or LetterRole.Radius or LetterRole.OpeningAngle or LetterRole.MoreTurns or LetterRole.IntermediatePoint => !turns,
        LetterRole.G => Meaning(token) is not (NcMeaning.Rapid or NcMeaning.Line or NcMeaning.ArcClockwise or NcMeaning.ArcCounterClockwise
            or NcMeaning.PlaneXY
                or NcMeaning.PlaneZX
                or NcMeaning.PlaneYZ
                or NcMeaning.Inch
                or NcMeaning.Metric
                or NcMeaning.Absolute
                or NcMeaning.Incremental
            or NcMeaning.AbsoluteCenters or NcMeaning.IncrementalCenters),
        _ => true,
    };

    private NcMeaning Meaning(NcToken token)
    {
        var tenths = token.Number.Value * 10;
        return tenths is >= 0 and < 10_000 && Math.Floor(tenths) == tenths ? path.Dialect.MeaningOf((int)tenths) : NcMeaning.Unknown;
    }

    private readonly record struct Word(byte Letter, NcNumber Number, int Start, int Length);
}
