using Avalonia;

namespace ErrorMatching.Hmi;

/// <summary>Where a label stands, in units of the screen.</summary>
/// <param name="Corner">Its left upper corner.</param>
/// <param name="Leader">The line that leads from its place to it where it stands away from it; null where it stands beside it.</param>
internal readonly record struct LabelRoom(Point Corner, (Point From, Point To)? Leader);
