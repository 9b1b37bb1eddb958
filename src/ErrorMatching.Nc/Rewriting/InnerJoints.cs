using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Moves the joints inside a run of displaced elements.</summary>
internal sealed class InnerJoints(DisplacedElements elements, PathChange change, ElementJoints joints, ShortPieces pieces)
{
    private readonly NcPath _path = change.Path;

    /// <summary>Moves the joints of a run at which its elements agree.</summary>
    /// <returns>The reason why the run cannot be displaced, or null.</returns>
    public Refusal? MoveSmooth(int first, int last)
    {
        // NaN if a joint is not smooth.
        var moves = new Vector2[last - first];
        if (TwoThreads.Refusal(first + 1, last + 1, (from, end) => SmoothMoves(first, from, end, moves)) is { } unfit)
        {
            return unfit;
        }

        var plane = _path.Motions[first].Plane;
        for (var joint = first + 1; joint <= last; joint++)
        {
            if (moves[joint - first - 1] is var move && !double.IsNaN(move.X))
            {
                change.Move(joint, plane, move);
                pieces.AddSmooth(joint);
            }
        }

        return null;
    }

    /// <summary>Moves the corners of a run that are not yet set.</summary>
    /// <returns>The reason why one cannot move, or null.</returns>
    public Refusal? MoveCorners(int first, int last)
    {
        for (var joint = first + 1; joint <= last; joint++)
        {
            if (!change.IsSet(joint) && Corner(joint, first, last) is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }

    // The displacements of the joints inside a run, if smooth and not yet set. Changes nothing, so two threads can run it.
    private Refusal? SmoothMoves(int first, int from, int end, Vector2[] moves)
    {
        var begin = _path.Motions[first];
        for (var joint = from; joint < end; joint++)
        {
            var motion = _path.Motions[joint];
            if (motion.Plane != begin.Plane)
            {
                return elements.At(
                    motion,
                    NcRefusalCodes.PlaneChange,
                    "the plane changes inside the named blocks. Name the blocks of each plane as a feature of its own.");
            }

            if (motion.Frame != begin.Frame)
            {
                return elements.At(motion, NcRefusalCodes.FrameChange, "the work offset or origin changes inside the named blocks.");
            }

            moves[joint - first - 1] = (change.IsSet(joint) ? null : joints.Smooth(joint - 1, joint)) ?? new(double.NaN, double.NaN);
        }

        return null;
    }

    /// <summary>Moves a corner to the intersection of both displaced elements. If one of them is a short piece of a polyline that ends
    /// before the intersection, tries the next piece: the displacement cut off the pieces between, and they shrink to the corner.</summary>
    private Refusal? Corner(int joint, int first, int last)
    {
        var (before, behind) = (joint - 1, joint);
        var amount = Math.Max(elements.WishOf(before).End.Length, elements.WishOf(behind).Start.Length);
        while (joints.Meet(before, behind, joint, amount) is { } point)
        {
            if (before > first && pieces.EndsBefore(before, point, atStart: true))
            {
                before--;
            }
            else if (behind < last && pieces.EndsBefore(behind, point, atStart: false))
            {
                behind++;
            }
            else if (behind > before + 1 && joints.IsVague(before, behind, point))
            {
                return elements.At(
                    _path.Motions[before + 1],
                    NcRefusalCodes.ElementFlips,
                    "displaced as asked, the corner beside it cuts it off, and what is left meets so shallowly that it could do so "
                        + "anywhere. Leave it out of the program, or displace less.");
            }
            else
            {
                pieces.Shrink(before + 1, behind, point);
                return null;
            }
        }

        return elements.At(
            _path.Motions[joint],
            NcRefusalCodes.NoIntersection,
            $"displaced as asked, it no longer meets {elements.NameOf(joint - 1)} nearby: {joints.WhyApart(joint - 1, joint)}");
    }
}
