using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Plans streamline passes of a ball end mill over a surface, along one of its parameters, with the center on the exact offset.
/// The scallop determines the spacing, and the chordal error the steps.</summary>
/// <remarks>Spacing and steps are predicted from the curvature of the surface and of the center's own curve, then measured on the finished
/// polyline with its rounded numbers. Anything out of tolerance is remade more finely. So the program itself is within the tolerances.
/// Ridge between two balls on a surface of normal curvature k across the pass: h = w² (1/R + k) / 8, k positive if the surface is
/// convex.</remarks>
public static class ToolPathPlanner
{
    /// <summary>Plans the path of a job's stage. On the way to each cut, the ball stays clear of what the stage before it leaves.</summary>
    /// <param name="surface">The surface to cut: the nominal one, or a compensated one.</param>
    /// <param name="job">The job: ball, tolerances, clearance and stock.</param>
    /// <param name="stage">The stage.</param>
    /// <param name="dialect">The control for the path.</param>
    /// <param name="moreMm">How much more material lies over the surface than the job says: for a compensated surface, by how much it was
    /// moved, and by how much the measured piece was too high.</param>
    /// <param name="progress">Gets the share of the path that is planned, 0 to 1, from several threads in turn; null if nobody
    /// asks.</param>
    /// <returns>As for the other overload, or a refusal because the ball would travel through the material that lies over the surface
    /// before the stage (<c>clearance-too-low</c>).</returns>
    /// <exception cref="ArgumentOutOfRangeException">As for the other overload.</exception>
    public static ToolPathResult Plan(
        PartSurface surface,
        FreeformJob job,
        CuttingStage stage,
        NcDialect dialect,
        double moreMm = 0,
        IProgress<double>? progress = null)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentOutOfRangeException.ThrowIfNegative(moreMm);
        var material = StageMaterial.Before(job, stage).And(moreMm, "by which the piece was too high and the surface was moved");
        return Plan(surface, job.Tool, job.Toolpath, job.Stock.Of(stage), dialect, material, new(progress));
    }

    /// <summary>Plans a path over a surface on which nothing lies but the stock that is left.</summary>
    /// <param name="surface">The surface to cut.</param>
    /// <param name="tool">The ball end mill.</param>
    /// <param name="toolpath">Direction, tolerances and clearance.</param>
    /// <param name="stockMm">Stock to leave on the surface along its normal, in millimeters.</param>
    /// <param name="dialect">The control for the path. Coordinates are rounded to its least increment.</param>
    /// <returns>The path, or a refusal: the increment is coarser than a tolerance (<c>increment-too-coarse</c>), the chord is not smaller
    /// than half of the stock (<c>chord-too-coarse</c>), the surface has no normal (<c>no-normal</c>), faces down (<c>faces-down</c>) or
    /// contains an edge (<c>edge-in-surface</c>), the ball does not fit (<c>ball-does-not-fit</c>) or cannot leave the surface
    /// (<c>no-way-out</c>), a tolerance cannot be met (<c>tolerance-not-reached</c>), or the path would be too long
    /// (<c>path-too-long</c>).</returns>
    /// <exception cref="ArgumentOutOfRangeException">A length is not positive, the stock is negative, or a value is not finite.</exception>
    public static ToolPathResult Plan(PartSurface surface, JobTool tool, JobToolpath toolpath, double stockMm, NcDialect dialect) =>
        Plan(surface, tool, toolpath, stockMm, dialect, new(stockMm, "the stock that is left"), new(null));

    private static ToolPathResult Plan(
        PartSurface surface,
        JobTool tool,
        JobToolpath toolpath,
        double stockMm,
        NcDialect dialect,
        StageMaterial material,
        PlanningProgress progress)
    {
        ArgumentNullException.ThrowIfNull(surface);
        ArgumentNullException.ThrowIfNull(tool);
        ArgumentNullException.ThrowIfNull(toolpath);
        ArgumentNullException.ThrowIfNull(dialect);
        Positive(tool.RadiusMm, nameof(tool));
        Positive(toolpath.ChordMm, nameof(toolpath));
        Positive(toolpath.ScallopMm, nameof(toolpath));
        Positive(toolpath.ClearanceMm, nameof(toolpath));
        if (!(stockMm >= 0) || !double.IsFinite(stockMm))
        {
            throw new ArgumentOutOfRangeException(nameof(stockMm), stockMm, "The stock is at least 0.");
        }

        var increment = Elementary.Pow(10, -dialect.MetricDecimals);
        var finest = Math.Min(toolpath.ChordMm, toolpath.ScallopMm);
        if (increment > finest * (1 + 1e-9))
        {
            return new Refusal("increment-too-coarse", string.Create(
                CultureInfo.InvariantCulture,
                $"{dialect.Name} writes {increment} mm, more than the {finest} mm that scallopMm and chordMm ask for: rounding alone "
                    + $"would exceed it. Ask for {increment} mm or more, or name a dialect whose metricDecimals is larger."));
        }

        // On a convex surface, chords cut into the stock. The gouge limit is twice the chord, so at half the stock it would be all of it.
        if (stockMm > 0 && toolpath.ChordMm >= stockMm / 2)
        {
            return new Refusal("chord-too-coarse", string.Create(
                CultureInfo.InvariantCulture,
                $"toolpath.chordMm is {toolpath.ChordMm} mm, but {stockMm} mm of stock are to stay: straight cuts may lie inside by the "
                    + $"chord, so it has to be less than {stockMm / 2} mm, half of the stock. State a smaller chordMm, or leave more stock "
                    + $"(stockMm)."));
        }

        var sheet = toolpath.AlongU ? surface : Turned(surface);
        var rounding = new CenterRounding(dialect.MetricDecimals, toolpath.ProgramsTip ? tool.RadiusMm : 0, finest);
        var context = new PlanningContext(new(sheet, tool.RadiusMm, stockMm), rounding, toolpath, material, progress);
        return new PathPlanning(context, dialect.MetricDecimals).Run();
    }

    // With u and v swapped, passes always run along u.
    private static PartSurface Turned(PartSurface surface) => surface with
    {
        Spline = surface.Spline.Swap(),
        Region = new([.. surface.Region.Loops.Select(l => (IReadOnlyList<Point2>)[.. l.Select(p => new Point2(p.Y, p.X))])]),
        Outside = -surface.Outside,
    };

    private static void Positive(double length, string name)
    {
        if (!(length > 0) || !double.IsFinite(length))
        {
            throw new ArgumentOutOfRangeException(name, length, "Radius, tolerances and clearance are positive lengths.");
        }
    }
}
