namespace ErrorMatching.Nc;

/// <summary>Lines that begin with a dollar sign: commands to the control, which are no blocks. The dialect states what each does; one that
/// it does not state can do anything.</summary>
internal sealed class SystemCommands(NcDialect dialect, ProgramRun run, CoordinateLayers layers, RunResult result, MotionWriter writer,
    ControlState control)
{
    private const byte Mark = (byte)'$';

    /// <summary>Handles such a line; false if the block is none.</summary>
    public bool Run(NcBlock block)
    {
        var text = run.Text.BytesOf(block).TrimStart((byte)' ');
        if (!dialect.SystemLines || text is not [Mark, ..])
        {
            return false;
        }

        var length = 1;
        while (length < text.Length && (SyntaxBytes.IsNamePart(text[length]) || text[length] == Mark))
        {
            length++;
        }

        var name = text[..length];
        switch (dialect.MeaningOf(name))
        {
            case NcMeaning.Harmless:
                break;
            case NcMeaning.OpaqueMotion:
                Move();
                break;
            case NcMeaning.Unsure:
                Move();
                layers.Forget();
                break;
            default:
                result.UnknownWord(NcText.Decode(name).ToUpperInvariant());
                layers.Forget();
                break;
        }

        run.At++;
        return true;
    }

    private void Move()
    {
        result.DependOnPlace();
        writer.Append(MotionKind.Cycle, MotionFlags.Cycle, control.State.Position, AxisSet.All);
    }
}
