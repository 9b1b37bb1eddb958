using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>What one core plans a path with: an offset surface of its own, the tolerances, and the reason to stop.</summary>
/// <param name="offset">The surface of exact centers.</param>
/// <param name="rounding">Rounding of centers to the program's increment.</param>
/// <param name="toolpath">Direction, tolerances and clearance.</param>
/// <param name="material">What lies over the surface before it is cut.</param>
/// <param name="progress">Is told what is planned.</param>
internal sealed class PlanningContext(
    OffsetSurface offset, CenterRounding rounding, JobToolpath toolpath, StageMaterial material, PlanningProgress progress)
{
    public OffsetSurface Offset { get; } = offset;

    public CenterRounding Rounding { get; } = rounding;

    public JobToolpath Toolpath { get; } = toolpath;

    public StageMaterial Material { get; } = material;

    public PlanningProgress Progress { get; } = progress;

    /// <summary>Why there is no path; null as long as nothing speaks against one.</summary>
    public Refusal? Refusal { get; set; }

    /// <summary>The polyline is within the chordal error of the exact offset. A center nearer than twice that touches elsewhere.</summary>
    public double GougeMm => 2 * Toolpath.ChordMm;

    /// <summary>Least distance of a center from the surface.</summary>
    public double NearestMm => Offset.DistanceMm - GougeMm;

    /// <summary>The most that may be left where the ball does not fit: the stock of the stage or the scallop, whichever is
    /// larger.</summary>
    public double MostRaisedMm => Math.Max(Toolpath.ScallopMm, Offset.StockMm);

    /// <summary>Distance of a center from the surface at which the ball is free of what lies there before the stage.</summary>
    public double FreeMm => Offset.RadiusMm + Math.Max(Material.Mm, Offset.StockMm);

    /// <summary>Least clearance over what the stage leaves with which the ball travels free of that.</summary>
    public double LeastClearanceMm => FreeMm - Offset.DistanceMm;

    /// <summary>The same for a part of the planning that runs on another core.</summary>
    public PlanningContext ForOtherCore() =>
        new(new(Offset.Surface, Offset.RadiusMm, Offset.StockMm), Rounding, Toolpath, Material, Progress);

    /// <summary>A builder of pieces on this surface.</summary>
    public PassBuilder Builder() => new(Offset, Rounding, Toolpath.ChordMm, PassBuilder.LiftShare * Toolpath.ScallopMm);

    public Point3 PlaceOf(Point2 at) => Offset.Left(at.X, at.Y).Place;

    /// <summary>A place in the surface's own parameters and in millimeters.</summary>
    public string Named(Point2 at)
    {
        var (u, v) = Toolpath.AlongU ? (at.X, at.Y) : (at.Y, at.X);
        return string.Create(CultureInfo.InvariantCulture, $"u {u:0.####}, v {v:0.####} ({PlaceText.Words(PlaceOf(at))})");
    }

    /// <summary>The refusal of a tolerance that cannot be met.</summary>
    public Refusal NotReached(string what, double found, double wanted, Point2 at) => new(
        "tolerance-not-reached",
        string.Create(
            CultureInfo.InvariantCulture,
            $"at {Named(at)} the {what} is {found:0.000000} mm, more than {wanted} mm, however close the points are laid. Allow more, or "
                + $"use a dialect with a finer increment than {Rounding.IncrementMm} mm."));
}
