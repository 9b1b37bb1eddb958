namespace ErrorMatching.Nc;

/// <summary>Reads the words of a block that is not plain, with values computed by the flow.</summary>
internal sealed class BlockReader(BlockValues values, ProgramRun run)
{
    /// <summary>Reads the words of a block.</summary>
    /// <param name="block">The block.</param>
    /// <param name="from">Start of its words, from its own start.</param>
    public void ReadTokens(NcBlock block, int from = 0) =>
        values.Words.ReadTokens(run.Text.Bytes.Span, block.Start + from, block.End, values.Dialect.Syntax, ValueOf);

    // Skips values of words that move nothing: tool names, angles of rotary axes, offsets.
    private double? ValueOf(NcToken token)
    {
        var role = token.Kind == NcTokenKind.PolarWord ? LetterRole.Axis : values.Dialect.RoleOf(token.Letter);
        var matters = role is LetterRole.Axis or LetterRole.Center or LetterRole.Radius or LetterRole.Feed or LetterRole.G or LetterRole.M
            or LetterRole.OpeningAngle or LetterRole.MoreTurns or LetterRole.IntermediatePoint
            || token.Letter is (byte)'P' or (byte)'Q' or (byte)'L' or (byte)'R' or (byte)'K';
        return matters && values.Dialect.HasMacros && token.ValueLength > 0 ? run.Compute(token.ValueStart, token.ValueLength) : double.NaN;
    }
}
