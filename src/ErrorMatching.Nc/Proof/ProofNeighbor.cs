namespace ErrorMatching.Nc;

/// <summary>A motion beside the named ones that moved along, as it may.</summary>
/// <param name="Block">Its block as the setter knows it.</param>
/// <param name="Line">Its line in the original, from 1.</param>
/// <param name="Role">How it follows.</param>
/// <param name="DisplacementMm">How far its moved end went.</param>
public sealed record ProofNeighbor(string Block, int Line, NeighborRole Role, double DisplacementMm);
