namespace ErrorMatching.Nc;

/// <summary>Finds the words that set the coordinates of a motion's end. If its own block has no word for an axis, the coordinate comes
/// from the last executed block that has one. Asking for the motions in order costs one pass over the words of the path.</summary>
/// <param name="path">The path.</param>
public sealed class CoordinateWords(NcPath path)
{
    private readonly CoordinateWord?[] _last = new CoordinateWord?[3];
    private int _next;

    /// <summary>The word that set a coordinate of a motion's end; null if no motion so far had one.</summary>
    /// <param name="motion">Position of the motion; not before one requested earlier.</param>
    /// <param name="axis">X, Y or Z.</param>
    /// <exception cref="ArgumentOutOfRangeException">The motion is before one requested earlier, or the axis is not X, Y or Z.</exception>
    public CoordinateWord? Behind(int motion, char axis)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(motion, _next - 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)(axis - 'X'), 3u, nameof(axis));
        for (; _next <= motion; _next++)
        {
            Read(path.Motions.BlockOf(_next));
        }

        return _last[axis - 'X'];
    }

    private void Read(int block)
    {
        foreach (var token in path.Program.Tokens(path.Program[block]))
        {
            if (token.Kind is NcTokenKind.Word or NcTokenKind.ExpressionWord && token.Letter is >= (byte)'X' and <= (byte)'Z')
            {
                _last[token.Letter - 'X'] = new(block, NcText.Decode(path.Program.Bytes.Span.Slice(token.Start, token.Length)));
            }
        }
    }
}

/// <summary>A word of a program that states a coordinate.</summary>
/// <param name="Block">Position of its block, from 0.</param>
/// <param name="Text">The word as written.</param>
public sealed record CoordinateWord(int Block, string Text);
