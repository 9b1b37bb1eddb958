namespace ErrorMatching.Cell;

/// <summary>Why a machine or a gauge does not answer.</summary>
/// <param name="Code">Stable word.</param>
/// <param name="Message">A sentence for the person who has to help.</param>
/// <param name="IsOfLogin">True if its login was refused: controls lock a login that is tried again and again.</param>
internal sealed record AnswerProblem(string Code, string Message, bool IsOfLogin = false);
