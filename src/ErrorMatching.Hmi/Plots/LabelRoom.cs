using Avalonia;

namespace ErrorMatching.Hmi;

/// <summary>Position of a label, in screen units.</summary>
/// <param name="Corner">Its upper left corner.</param>
/// <param name="Leader">Leader line from the marked place to the label; null if the label is next to its place.</param>
internal readonly record struct LabelRoom(Point Corner, (Point From, Point To)? Leader);
