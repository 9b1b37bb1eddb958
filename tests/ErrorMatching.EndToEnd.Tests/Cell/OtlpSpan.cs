namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A span as it arrives at a receiver of telemetry.</summary>
/// <param name="Service">The service's name.</param>
/// <param name="Name">Its own.</param>
/// <param name="Trace">The trace that it is of, in hexadecimal digits.</param>
/// <param name="Id">Its number.</param>
/// <param name="Parent">The number of the span that it is part of; empty for the first.</param>
/// <param name="Start">Nanoseconds since 1970.</param>
/// <param name="End">Nanoseconds since 1970.</param>
internal sealed record OtlpSpan(string Service, string Name, string Trace, string Id, string Parent, ulong Start, ulong End);
