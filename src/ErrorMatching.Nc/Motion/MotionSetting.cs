namespace ErrorMatching.Nc;

/// <summary>What stays the same over many motions.</summary>
/// <param name="Feed">Feed in mm/min as last programmed.</param>
/// <param name="Frame">Counts the changes of offsets and origins.</param>
internal readonly record struct MotionSetting(double Feed, int Frame);
