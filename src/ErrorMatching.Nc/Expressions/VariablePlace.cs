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
