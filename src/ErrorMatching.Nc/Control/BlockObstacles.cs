namespace ErrorMatching.Nc;

/// <summary>Finds words that prevent following or changing a block.</summary>
internal sealed class BlockObstacles(NcControl control, BlockStatements statements, BlockSteering steering)
{
    private static readonly uint Feeds = BlockWords.Bit('F') | BlockWords.Bit('S');

    public MotionFlags Read()
    {
        var flags = MotionFlags.None;
        if (control.Words.Statements.Length > 0)
        {
            flags |= statements.Read();
        }

        if (control.Words.Invalid.Length > 0)
        {
            flags |= control.Result.UnknownWord(control.Run.TextOf(control.Words.Invalid));
            control.Layers.Forget();
        }

        if (control.Words.Semicolon.Length > 1)
        {
            flags |= steering.ReadSemicolon();
        }

        var given = control.Words.Present | control.Words.Computed;
        if ((given & control.Values.UnknownLetters) != 0)
        {
            for (var letter = 'A'; letter <= 'Z'; letter++)
            {
                flags |= (given & control.Values.UnknownLetters & BlockWords.Bit(letter)) != 0
                    ? control.Result.UnknownWord(letter.ToString())
                    : MotionFlags.None;
            }
        }

        if ((control.Words.Computed & ~Feeds) != 0 && !control.Dialect.HasMacros)
        {
            flags |= control.Result.UnknownWord("a computed value");
            control.Layers.Forget();
        }

        if ((control.Words.Computed & (BlockWords.Bit('G') | BlockWords.Bit('M'))) != 0)
        {
            control.Layers.Forget();
        }

        if ((control.Words.Repeated & BlockWords.GeometryWords) != 0)
        {
            flags |= control.Result.Problem("repeated-word",
                "A coordinate stands twice in the block; which one counts depends on the control.",
                MotionFlags.UnknownWord);
        }

        flags |= (control.Words.Computed & BlockWords.GeometryWords) != 0 ? MotionFlags.Expression : MotionFlags.None;
        flags |= control.Words.Corner != 0 ? MotionFlags.CornerWord : MotionFlags.None;
        control.State.ModalRounding = control.Words.Corner == 'M' ? control.Values.CornerLength() : control.State.ModalRounding;
        return flags | ((given & control.Values.OtherAxes) != 0 ? MotionFlags.OtherAxis : MotionFlags.None);
    }
}
