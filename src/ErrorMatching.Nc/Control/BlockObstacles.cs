namespace ErrorMatching.Nc;

/// <summary>Finds words that prevent following or changing a block.</summary>
internal sealed class BlockObstacles(
    ControlState control,
    BlockValues values,
    ProgramRun run,
    CoordinateLayers layers,
    RunResult result,
    BlockStatements statements,
    MachineSwitches switches)
{
    private static readonly uint Feeds = BlockWords.Bit('F') | BlockWords.Bit('S');

    public MotionFlags Read()
    {
        var flags = MotionFlags.None;
        if (values.Words.Statements.Length > 0)
        {
            flags |= statements.Read();
        }

        if (values.Words.Invalid.Length > 0)
        {
            flags |= result.UnknownWord(run.TextOf(values.Words.Invalid));
            layers.Forget();
        }

        if (values.Words.Semicolon.Length > 1)
        {
            flags |= switches.ReadSemicolon();
        }

        var given = values.Words.Present | values.Words.Computed;
        if ((given & values.UnknownLetters) != 0)
        {
            for (var letter = 'A'; letter <= 'Z'; letter++)
            {
                flags |= (given & values.UnknownLetters & BlockWords.Bit(letter)) != 0 ? result.UnknownWord(letter.ToString())
                    : MotionFlags.None;
            }
        }

        if ((values.Words.Computed & ~Feeds) != 0 && !values.Dialect.HasMacros)
        {
            flags |= result.UnknownWord("a computed value");
            layers.Forget();
        }

        if ((values.Words.Computed & (BlockWords.Bit('G') | BlockWords.Bit('M'))) != 0)
        {
            layers.Forget();
        }

        if ((values.Words.Repeated & BlockWords.GeometryWords) != 0)
        {
            flags |= result.Problem("repeated-word", "A coordinate stands twice in the block; which one counts depends on the control.",
                MotionFlags.UnknownWord);
        }

        flags |= (values.Words.Computed & BlockWords.GeometryWords) != 0 ? MotionFlags.Expression : MotionFlags.None;
        flags |= values.Words.Corner != 0 ? MotionFlags.CornerWord : MotionFlags.None;
        control.State.ModalRounding = values.Words.Corner == 'M' ? values.CornerLength() : control.State.ModalRounding;
        return flags | ((given & values.OtherAxes) != 0 ? MotionFlags.OtherAxis : MotionFlags.None);
    }
}
