namespace ErrorMatching.Nc;

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
