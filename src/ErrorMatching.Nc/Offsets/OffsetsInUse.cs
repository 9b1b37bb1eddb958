namespace ErrorMatching.Nc;

/// <summary>Which offsets of the control apply to the motions of a program.</summary>
public static class OffsetsInUse
{
    private const MotionFlags Sides = MotionFlags.CompensationLeft | MotionFlags.CompensationRight;

    /// <summary>The number of the radius offset (D) for each motion: null without cutter compensation, NaN if the program does not tell
    /// the number, or gives the diameter itself.</summary>
    public static double?[] RadiusNumbers(NcPath path)
    {
        ArgumentNullException.ThrowIfNull(path);
        var numbers = new double?[path.Motions.Length];
        var (next, number) = (0, double.NaN);
        for (var i = 0; i < numbers.Length; i++)
        {
            for (; next < path.CompensationSwitches.Count && path.CompensationSwitches[next].Joint <= i; next++)
            {
                var found = path.CompensationSwitches[next];
                number = found.Meaning switch
                {
                    NcMeaning.CompensationLeft or NcMeaning.CompensationRight or NcMeaning.Harmless => found.Offset ?? double.NaN,
                    NcMeaning.CompensationLeftByDiameter or NcMeaning.CompensationRightByDiameter => double.NaN,
                    _ => number,
                };
            }

            numbers[i] = path.Motions[i].Has(Sides) ? number : null;
        }

        return numbers;
    }

    /// <summary>The number of the work offset for each motion, from 1: 0 for moves to machine positions, and -1 if it cannot be changed or
    /// the program does not tell it.</summary>
    public static int[] WorkOffsets(NcPath path)
    {
        ArgumentNullException.ThrowIfNull(path);
        int[] ofFrames = [
            .. path.Frames.Select(f => f.WorkOffsetNumber != 0 ? 0 : OffsetProgram.NumberOf(path.Dialect, f.WorkOffset)).Select(
                n => n > 0 ? n : -1)];
        var numbers = new int[path.Motions.Length];
        for (var i = 0; i < numbers.Length; i++)
        {
            var motion = path.Motions[i];
            numbers[i] = motion.Has(MotionFlags.MachineMove) ? 0 : ofFrames[motion.Frame];
        }

        return numbers;
    }
}
