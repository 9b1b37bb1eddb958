namespace ErrorMatching.Nc;

/// <summary>How a variable is named.</summary>
internal enum VariableKind : byte
{
    /// <summary>By a number: <c>#100</c>, <c>R1</c>.</summary>
    Numbered,

    /// <summary>By a name: <c>#&lt;depth&gt;</c>, <c>DEPTH</c>.</summary>
    Named,

    /// <summary>By a name and a place in it: <c>DEPTH[2]</c>.</summary>
    Element,

    /// <summary>A variable of the machine, which no program can know: <c>$P_ACTFRAME</c>.</summary>
    Machine,
}
