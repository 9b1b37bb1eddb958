namespace ErrorMatching.Nc;

/// <summary>A reference to a variable: a number, a name, an array element, or machine data that a program cannot know.</summary>
/// <param name="Kind">Its kind.</param>
/// <param name="Number">Number of a numbered variable; position in an array.</param>
/// <param name="Name">Name of a named variable or array, as stored by <see cref="VariableNames"/>.</param>
internal readonly record struct VariablePlace(VariableKind Kind, int Number, string? Name)
{
    public static VariablePlace Machine => new(VariableKind.Machine, 0, null);

    public static VariablePlace OfMachine(string name) => new(VariableKind.Machine, 0, name);

    public static VariablePlace Numbered(int number) => new(VariableKind.Numbered, number, null);

    public static VariablePlace Named(string name) => new(VariableKind.Named, 0, name);

    public static VariablePlace Element(string name, int position) => new(VariableKind.Element, position, name);
}

/// <summary>Kind of a reference to a variable.</summary>
internal enum VariableKind : byte
{
    /// <summary>By a number: <c>#100</c>, <c>R1</c>.</summary>
    Numbered,

    /// <summary>By a name: <c>#&lt;depth&gt;</c>, <c>DEPTH</c>.</summary>
    Named,

    /// <summary>By a name and an index: <c>DEPTH[2]</c>.</summary>
    Element,

    /// <summary>A machine variable, whose value no program can know: <c>$P_ACTFRAME</c>.</summary>
    Machine,
}

/// <summary>Where a variable is kept.</summary>
/// <param name="Level">The level of calls, 0 for the innermost; -1 for common variables, -2 for what was assumed of one and is
/// replaced.</param>
/// <param name="Name">Its name, or that of its array; null if it has a number only.</param>
/// <param name="Number">Its number, or its place in the array.</param>
internal readonly record struct VariableKey(int Level, string? Name, int Number);
