// nothing: the descriptor is what is wrong
