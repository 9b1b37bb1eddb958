namespace ErrorMatching.Nc;

/// <summary>The radii for cutter compensation that a program itself gives: by a diameter in the block (G41.1), a definition of the tool
/// (TOOL DEF), or an oversize of its call (DR).</summary>
public static class ProgramRadii
{
    private const MotionFlags Sides = MotionFlags.CompensationLeft | MotionFlags.CompensationRight;

    /// <summary>The radius for each motion, mm: null without compensation and where the control's table alone gives it, NaN if only the
    /// machine knows it.</summary>
    /// <param name="path">The path; its dialect has the radii of the control's table.</param>
    public static double?[] Of(NcPath path)
    {
        ArgumentNullException.ThrowIfNull(path);
        var radii = new double?[path.Motions.Length];
        var (next, radius) = (0, default(double?));
        for (var i = 0; i < radii.Length; i++)
        {
            for (; next < path.CompensationSwitches.Count && path.CompensationSwitches[next].Joint <= i; next++)
            {
                radius = Of(path.CompensationSwitches[next], path.Dialect.ToolRadii, radius);
            }

            radii[i] = path.Motions[i].Has(Sides) ? radius : null;
        }

        return radii;
    }

    private static double? Of(in CompensationSwitch found, ToolRadii table, double? before) => found.Meaning switch
    {
        NcMeaning.CompensationLeftByDiameter or NcMeaning.CompensationRightByDiameter => (found.Offset * found.Unit / 2) ?? double.NaN,
        NcMeaning.CompensationLeft or NcMeaning.CompensationRight when found.Radius is { } radius => radius + found.Oversize,
        NcMeaning.CompensationLeft or NcMeaning.CompensationRight when found.Oversize != 0 =>
            (table.For(found.Offset) ?? double.NaN) + found.Oversize,
        NcMeaning.CompensationLeft or NcMeaning.CompensationRight => null,
        _ => before,
    };
}
