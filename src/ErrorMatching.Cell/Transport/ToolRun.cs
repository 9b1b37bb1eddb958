namespace ErrorMatching.Cell;

/// <summary>A run of a program: what it is told, and when it is ended.</summary>
/// <param name="Program">Name of the program, found by PATH.</param>
/// <param name="Arguments">Its arguments, one by one; no shell reads them. No secrets: every user of the computer can see them.</param>
/// <param name="Input">What it reads.</param>
/// <param name="Limit">It is killed after this time.</param>
internal sealed record ToolRun(string Program, IReadOnlyList<string> Arguments, ReadOnlyMemory<byte> Input, TimeSpan Limit)
{
    /// <summary>It is killed when it says more than this.</summary>
    public long MostOutput { get; init; } = 4 << 20;

    /// <summary>Variables beside those that every program gets.</summary>
    public IReadOnlyList<(string Name, string Value)> Environment { get; init; } = [];

    /// <summary>Asked ten times a second: it is killed when this says so. For programs that write to files. Null: nothing of that kind.</summary>
    public Func<bool>? IsTooMuch { get; init; }
}
