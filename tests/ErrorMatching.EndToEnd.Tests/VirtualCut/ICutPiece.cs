namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A piece of the tool's path in the working plane, with what the referee must know of it.</summary>
internal interface ICutPiece
{
    /// <summary>Tool left or right of the programmed path, or none: the piece is the path of the tool's center.</summary>
    CutterSide Side { get; }

    /// <summary>Distance from a place to the nearest point of the piece.</summary>
    double DistanceTo(Flat place);

    /// <summary>Where a line (place + t * unit direction) meets the piece: t, and the direction of travel there.</summary>
    IEnumerable<(double T, Flat Travel)> Crossings(Flat place, Flat direction);
}
