namespace ErrorMatching.Cell;

/// <summary>Why a machine or a gauge does not respond.</summary>
/// <param name="Code">Stable code.</param>
/// <param name="Message">A sentence for the person who has to fix it.</param>
/// <param name="IsOfLogin">True if the login was refused: controls lock a login after repeated attempts.</param>
internal sealed record AnswerProblem(string Code, string Message, bool IsOfLogin = false);
