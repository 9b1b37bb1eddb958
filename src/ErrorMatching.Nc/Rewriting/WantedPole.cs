using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>What an arc wants of the center that another block states.</summary>
/// <param name="Move">The center's best move, in increments.</param>
/// <param name="Free">The arc, if other moves may fit it too; null if only this one does.</param>
internal readonly record struct WantedPole((long First, long Second) Move, (Point2 Start, Point2 End, Point2 Center)? Free)
{
    /// <summary>True if a move of the center fits the arc: the radii agree, and the center is next to the exact one.</summary>
    public bool Accepts((long First, long Second) move, Point2 center, double increment)
    {
        if (move == Move || Free is not { } arc)
        {
            return move == Move;
        }

        var moved = center + new Vector2(move.First * increment, move.Second * increment);
        return moved.DistanceTo(arc.Center) <= 1.5 * increment
            && ArcCenter.Mismatch(arc.Start, arc.End, moved) <= CenterGrid.WantedMismatchMm;
    }
}
