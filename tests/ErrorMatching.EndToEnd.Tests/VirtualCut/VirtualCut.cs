namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// The piece that a program leaves in one plane. Without cutter compensation the feed moves carry the center of a round tool and the
/// boundary is the envelope of its circle; under G41 and G42 the programmed path itself is the boundary (a control that compensates cuts
/// along it).
/// </summary>
internal sealed class VirtualCut
{
    private readonly List<ICutPiece> _centers = [];
    private readonly List<ICutPiece> _contours = [];
    private readonly double _toolRadius;

    public VirtualCut(IEnumerable<RefereeMove> moves, double toolRadius, WorkPlane plane = WorkPlane.XY)
    {
        _toolRadius = toolRadius;
        foreach (var move in moves.Where(m => !m.Rapid))
        {
            (move.Side == CutterSide.None ? _centers : _contours).Add(Piece(move, plane));
        }
    }

    /// <summary>How far a place lies inside the material that the tool's circle leaves:
    /// positive in material, zero on the boundary, negative where it was cut.</summary>
    public double Clearance(Flat place) => _centers.Min(p => p.DistanceTo(place)) - _toolRadius;

    /// <summary>
    /// Where the boundary lies on the normal through a key point, as a signed distance from the key point along the normal.
    /// The normal points from the material to the tool: a positive answer means that more material stands than the key point says.
    /// </summary>
    /// <exception cref="RefereeException">Nothing was cut there, or (under G41 and G42) the tool ran on the other side.</exception>
    public double Probe(Flat keyPoint, Flat normal, double reach = 2)
    {
        var unit = normal.Unit();
        return _contours.Count > 0 ? ProbeContour(keyPoint, unit, reach) : ProbeEnvelope(keyPoint, unit, reach);
    }

    private double ProbeContour(Flat keyPoint, Flat unit, double reach)
    {
        var crossings = _contours
            .SelectMany(p => p.Crossings(keyPoint, unit).Select(c => (c.T, c.Travel, p.Side)))
            .Where(c => Math.Abs(c.T) <= reach)
            .ToList();
        if (crossings.Count == 0)
        {
            throw new RefereeException($"no contour within {reach:R} of {keyPoint}");
        }

        var (t, travel, side) = crossings.MinBy(c => Math.Abs(c.T));
        if (unit.Dot(travel.Left) > 0 != (side == CutterSide.Left))
        {
            throw new RefereeException($"the tool runs on the material's side at {keyPoint}");
        }

        return t;
    }

    /// <summary>
    /// Comes from the place of the tool's center, as a probe does, toward the material.
    /// The clearance changes by no more than the way travelled, so a step of its own size cannot jump over the boundary.
    /// </summary>
    private double ProbeEnvelope(Flat keyPoint, Flat unit, double reach)
    {
        double At(double t) => Clearance(keyPoint + (unit * t));
        var air = _toolRadius;
        var clearance = At(air);
        if (clearance >= 0)
        {
            throw new RefereeException($"nothing was cut at {keyPoint}");
        }

        var metal = air;
        while (clearance < 0)
        {
            air = metal;
            metal = air - Math.Max(-clearance, 1e-4);
            clearance = At(metal);
            if (metal < -reach)
            {
                throw new RefereeException($"no material within {reach:R} of {keyPoint}");
            }
        }

        while (air - metal > 1e-9)
        {
            var middle = (air + metal) / 2;
            if (At(middle) < 0)
            {
                air = middle;
            }
            else
            {
                metal = middle;
            }
        }

        return (air + metal) / 2;
    }

    private static ICutPiece Piece(RefereeMove move, WorkPlane plane)
    {
        if (!move.IsArc)
        {
            return new CutSegment(move.From.In(plane), move.To.In(plane), move.Side);
        }

        return move.Plane == plane
            ? new CutArc(move.Center, move.Radius, (move.From.In(plane) - move.Center).Heading, move.Sweep, move.Side)
            : throw new RefereeException($"line {move.Line}: an arc outside the plane that is judged");
    }
}
