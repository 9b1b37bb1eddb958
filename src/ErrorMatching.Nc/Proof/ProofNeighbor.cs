namespace ErrorMatching.Nc;

/// <summary>An unnamed motion that moved along with the named ones, as allowed.</summary>
/// <param name="Block">Name of its block, as the setter knows it.</param>
/// <param name="Line">Its line in the original, from 1.</param>
/// <param name="Role">How it follows.</param>
/// <param name="DisplacementMm">How far it moved at most, at its ends and between them, mm.</param>
public sealed record ProofNeighbor(string Block, int Line, NeighborRole Role, double DisplacementMm);
