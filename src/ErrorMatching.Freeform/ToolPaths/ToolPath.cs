using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The path of a ball end mill over a surface, with the measured errors. For a long path, it stores only the definitions of the
/// passes and recalculates identical points on demand.</summary>
public sealed class ToolPath
{
    private readonly Func<PassBuilder> _builder;
    private readonly OffsetSurface _offset;
    private readonly CenterRounding _rounding;
    private readonly IReadOnlyList<CutChain> _chains;

    internal ToolPath(
        Func<PassBuilder> builder, OffsetSurface offset, CenterRounding rounding, IReadOnlyList<CutChain> chains, ToolPathPlan plan)
    {
        (_builder, _offset, _rounding, _chains) = (builder, offset, rounding, chains);
        (Passes, Points, LengthMm, TravelCenterZ, Certificate, Decimals) = (
            plan.Passes, plan.Points, plan.LengthMm, plan.TravelCenterZ, plan.Certificate, plan.Decimals);
    }

    /// <summary>Radius of the ball in millimeters.</summary>
    public double RadiusMm => _offset.RadiusMm;

    /// <summary>Stock left on the surface, in millimeters.</summary>
    public double StockMm => _offset.StockMm;

    /// <summary>Number of passes over the surface.</summary>
    public int Passes { get; }

    /// <summary>Number of points on the surface, without leads and positioning.</summary>
    public int Points { get; }

    /// <summary>Length of the cuts in millimeters, without leads and positioning.</summary>
    public double LengthMm { get; }

    /// <summary>Travel height of the ball's center, in millimeters.</summary>
    public double TravelCenterZ { get; }

    /// <summary>Decimals to which the coordinates are rounded.</summary>
    public int Decimals { get; }

    /// <summary>The measurements of the finished path.</summary>
    public ToolPathCertificate Certificate { get; }

    /// <summary>All moves of the ball's center in order, from above the first point at travel height. Needs memory for one pass.</summary>
    public IEnumerable<ToolMove> Moves()
    {
        var builder = _builder();
        var line = new CenterLine();
        foreach (var chain in _chains)
        {
            var last = default(Point3);
            for (var i = 0; i < chain.Pieces.Count; i++)
            {
                var piece = chain.Pieces[i];
                if (piece.Centers is null)
                {
                    builder.Build(piece, line);
                }

                var count = piece.Centers?.Count ?? line.Count;
                for (var k = 0; k < count; k++)
                {
                    var at = piece.Backwards ? count - 1 - k : k;
                    var center = piece.Centers is { } centers ? centers[at] : line.Centers[at];
                    if (i == 0 && k == 0)
                    {
                        var above = _rounding.Nearest(center + chain.LeadIn);
                        yield return new(above with { Z = TravelCenterZ }, true);
                        yield return new(above, true);
                    }

                    if (center != last || (i == 0 && k == 0))
                    {
                        yield return new(center, false);
                    }

                    last = center;
                }
            }

            var leave = _rounding.Nearest(last + chain.LeadOut);
            yield return new(leave, false);
            yield return new(leave with { Z = TravelCenterZ }, true);
        }
    }
}

/// <summary>A straight move of the ball's center.</summary>
/// <param name="Center">Its end, in millimeters.</param>
/// <param name="IsRapid">True for positioning in the air, false for a move at feed.</param>
public readonly record struct ToolMove(Point3 Center, bool IsRapid);

/// <summary>The figures of a finished path.</summary>
internal sealed record ToolPathPlan(
    int Passes, int Points, double LengthMm, double TravelCenterZ, ToolPathCertificate Certificate, int Decimals);
