namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A key point whose truth is known.</summary>
/// <param name="Label">Label, unique in the part.</param>
/// <param name="Place">Nominal place in the program's frame, on the boundary that the undisplaced program cuts.</param>
/// <param name="Normal">Unit normal there, from the counterpart's material to its tool, in the program's frame.</param>
/// <param name="Deviation">Actual - nominal of the part along the normal, mm.</param>
/// <param name="Theoretical">The nominal place in the part's frame.</param>
/// <param name="Actual">The deviated place in the part's frame.</param>
internal sealed record RandomKeyPoint(string Label, Flat Place, Flat Normal, double Deviation, Flat Theoretical, Flat Actual);
