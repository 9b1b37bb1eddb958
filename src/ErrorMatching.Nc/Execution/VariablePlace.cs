namespace ErrorMatching.Nc;

/// <summary>Which variable is meant: a number, a name, an element of an array, or something of the machine that a program cannot
/// know.</summary>
/// <param name="Kind">Which of these.</param>
/// <param name="Number">Number of a numbered variable; position in an array.</param>
/// <param name="Name">Name of a named variable or array, as <see cref="VariableNames"/> keeps it.</param>
internal readonly record struct VariablePlace(VariableKind Kind, int Number, string? Name)
{
    public static VariablePlace Machine => new(VariableKind.Machine, 0, null);

    public static VariablePlace Numbered(int number) => new(VariableKind.Numbered, number, null);

    public static VariablePlace Named(string name) => new(VariableKind.Named, 0, name);

    public static VariablePlace Element(string name, int position) => new(VariableKind.Element, position, name);
}
